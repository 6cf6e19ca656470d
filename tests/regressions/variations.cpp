#include "tests/regressions/variations.h"

#include "soms/base/random.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/bodies.h"
#include "tests/support/truth/query_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>

namespace soms::test {

namespace {

using Pairs = std::vector<TrianglePair>;

/// The mesh after `there`, or nothing if `back` does not restore every vertex.
template <class There, class Back>
std::optional<Mesh> exactly_mapped(const Mesh& mesh, const There& there, const Back& back) {
  Mesh changed = mapped(mesh, there);
  return mapped(changed, back).vertices == mesh.vertices ? std::optional(changed) : std::nullopt;
}

Body at(const Mesh& mesh, const Pose& pose = {}) {
  return Body(mesh, pose);
}

using Check = std::function<void(const Variation&)>;

void vary_vertices(const Mesh& a, const Mesh& b, const Check& check) {
  for (const Pose& turn : cube_rotations()) {
    const auto rotate = [&turn](const Vec3& v) { return turn.apply(v); };
    check({.what = "rotated vertices", .a = at(mapped(a, rotate)), .b = at(mapped(b, rotate))});
    check({.what = "rotated by pose", .a = at(a, turn), .b = at(b, turn)});
  }
  for (int k = -40; k <= 40; ++k) {
    const auto scaled = [k](int sign) {
      return [k, sign](const Vec3& v) { return v * std::ldexp(1.0, sign * k); };
    };
    const auto scaled_a = exactly_mapped(a, scaled(1), scaled(-1));
    const auto scaled_b = exactly_mapped(b, scaled(1), scaled(-1));
    if (scaled_a && scaled_b) {
      check({.what = "scaled by 2^" + std::to_string(k),
             .a = at(*scaled_a),
             .b = at(*scaled_b),
             .exponent = k});
    }
  }
  const Vec3 shift{0x1p20, -0x1p21, 0x1p19};
  const auto there = [&](const Vec3& v) { return v + shift; };
  const auto back = [&](const Vec3& v) { return v - shift; };
  const auto far_a = exactly_mapped(a, there, back);
  const auto far_b = exactly_mapped(b, there, back);
  if (far_a && far_b) {
    check({.what = "shifted", .a = at(*far_a), .b = at(*far_b)});
    const Pose pose = Pose::translation(shift.x, shift.y, shift.z);
    check({.what = "shifted by pose", .a = at(a, pose), .b = at(b, pose)});
  }
}

/// A mesh with triangles and corners in another order, and where each triangle went.
struct Shuffled {
  Mesh mesh;
  std::vector<TriangleId> place;
};

Shuffled shuffled(const Mesh& mesh, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<TriangleId> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[rng.below(i)]);
  }
  Shuffled result{mesh, std::vector<TriangleId>(order.size())};
  for (TriangleId i = 0; i < order.size(); ++i) {
    auto corners = mesh.triangles[order[i]];
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(rng.below(3)),
                corners.end());
    if (rng.below(2) == 0) {
      std::swap(corners[0], corners[1]);
    }
    result.mesh.triangles[i] = corners;
    result.place[order[i]] = i;
  }
  return result;
}

void vary_order(const Mesh& a, const Mesh& b, const Check& check) {
  check({.what = "swapped", .a = at(b), .b = at(a), .exchanged = true});
  const Shuffled x = shuffled(a, 1);
  const Shuffled y = shuffled(b, 2);
  check({.what = "permuted",
         .a = at(x.mesh),
         .b = at(y.mesh),
         .place_a = x.place,
         .place_b = y.place});
}

void vary_machinery(const Mesh& a, const Mesh& b, const Check& check) {
  for (const RuleEntry& rule : rules()) {
    for (const int leaf : {1, 4, 1000}) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        const ShapeOptions options{.build = {.rule = rule.rule, .per_leaf = leaf},
                                   .layout = layout};
        check({.what = std::string(rule.name) + (layout == Layout::compact ? ", compact" : "") +
                       ", leaves of " + std::to_string(leaf),
               .a = Body(Shape(a, options)),
               .b = Body(Shape(b, options))});
      }
    }
  }
  for (const int threads : {2, 8}) {
    check({.what = std::to_string(threads) + " threads",
           .a = at(a),
           .b = at(b),
           .limits = {.threads = threads}});
  }
}

void expect_pairs(const Overlap& answer, const Pairs& expected, const std::string& what) {
  EXPECT_EQ(answer.any, !expected.empty()) << what;
  EXPECT_EQ(answer.pairs, expected) << what;
  EXPECT_EQ(answer.coverage, Coverage::complete) << what;
}

/// The pairs as the variation names them.
Pairs renamed(const Pairs& pairs, const Variation& variation) {
  Pairs result;
  for (const auto& [i, j] : pairs) {
    const TriangleId x = variation.place_a.empty() ? i : variation.place_a[i];
    const TriangleId y = variation.place_b.empty() ? j : variation.place_b[j];
    result.emplace_back(variation.exchanged ? TrianglePair{y, x} : TrianglePair{x, y});
  }
  std::sort(result.begin(), result.end());
  return result;
}

void vary_traversals(const Mesh& a, const Mesh& b, const Pairs& expected) {
  const ShapeOptions kept{.keep_tree = true};
  const Body body_a{Shape(a, kept)};
  const Body body_b{Shape(b, kept)};
  for (const TraversalEntry& entry : traversals()) {
    const Overlap answer = thesis::overlap(body_a, body_b, {.traversal = entry.traversal}).answer;
    expect_pairs(answer, expected, std::string(entry.name));
  }
}

void vary_modes(const Mesh& a, const Mesh& b, const Pairs& expected) {
  for (const int threads : {1, 2}) {
    Limits limits;
    limits.threads = threads;
    OverlapOptions options;
    options.mode = OverlapMode::any;
    const Overlap any = overlap(Body(a), Body(b), options, limits);
    EXPECT_EQ(any.any, !expected.empty());
    EXPECT_EQ(any.pairs.size(), expected.empty() ? 0U : 1U);
    for (const TrianglePair& pair : any.pairs) {
      EXPECT_TRUE(std::binary_search(expected.begin(), expected.end(), pair));
    }
    options.mode = OverlapMode::first;
    const Overlap first = overlap(Body(a), Body(b), options, limits);
    EXPECT_EQ(first.pairs, Pairs(expected.begin(), expected.begin() + (expected.empty() ? 0 : 1)));
  }
}

void vary_batch(const Mesh& a, const Mesh& b, const Pairs& expected) {
  const std::vector<Pose> poses = poses_around(a);
  for (const int threads : {1, 2}) {
    const OverlapBatch batch = overlap(Shape(a), poses, Body(b), {}, {.threads = threads});
    ASSERT_EQ(batch.size(), poses.size());
    const auto pairs = batch.pairs_of(kPlaceInBatch);
    EXPECT_EQ(Pairs(pairs.begin(), pairs.end()), expected) << "in a batch";
    EXPECT_EQ(batch.any[kPlaceInBatch] != 0, !expected.empty()) << "in a batch";
  }
}

/// What is true of the variation, given what is true of the case. Of equally near pairs a variation
/// that renames may have another that is the least; the twin says which.
PairTruth truth_for(const Variation& variation, const PairTruth& truth) {
  if (variation.exchanged || !variation.place_a.empty()) {
    PairTruth other = truth_of(variation.a, variation.b);
    EXPECT_EQ(other.distance.distance, truth.distance.distance) << variation.what;
    return other;
  }
  PairTruth scaled = truth;
  Bracket& d = scaled.distance.distance;
  d = {std::ldexp(d.lower, variation.exponent), std::ldexp(d.upper, variation.exponent)};
  return scaled;
}

/// The rows about lengths, where their answers turn.
void expect_near(const Variation& variation, const PairTruth& truth) {
  for (const QueryRow& row : query_table()) {
    if (!row.takes_length) {
      continue;
    }
    for (const double length : lengths_around(row, truth.distance.distance)) {
      const Answer answer = row.ask(variation.a, variation.b, {.length = length}, variation.limits);
      EXPECT_EQ(row.fault(answer, truth, variation.a, variation.b, length), "")
          << variation.what << ", " << row.name << " at " << length << ": " << row.text(answer);
    }
  }
}

void expect_near_in_batch(const Mesh& a, const Mesh& b, const PairTruth& truth) {
  const Body x(a);
  const Body y(b);
  const std::vector<Pose> poses = poses_around(a);
  for (const QueryRow& row : query_table(x, y)) {
    for (const int threads : {1, 2}) {
      const double length = truth.distance.distance.upper;
      const BatchAnswer batch =
          row.ask_batch(x.shape, poses, y, {.length = length}, {.threads = threads});
      ASSERT_EQ(batch.answers.size(), poses.size());
      const Answer& answer = batch.answers[kPlaceInBatch];
      EXPECT_EQ(row.fault(answer, truth, x, y, length), "")
          << "in a batch, " << row.name << ": " << row.text(answer);
    }
  }
}

}  // namespace

void for_each_variation(const Mesh& a, const Mesh& b, const Check& check) {
  check({.what = "as given", .a = at(a), .b = at(b)});
  vary_vertices(a, b, check);
  vary_order(a, b, check);
  vary_machinery(a, b, check);
}

std::vector<Pose> poses_around(const Mesh& a) {
  const Vec3 size = bounds(a).extent();
  Rng rng(3);
  std::vector<Pose> poses(1000);
  for (Pose& pose : poses) {
    pose = Pose::about_z(
        rng.uniform(-3, 3),
        {size.x * rng.uniform(-1, 1), size.y * rng.uniform(-1, 1), size.z * rng.uniform(-1, 1)});
  }
  poses[kPlaceInBatch] = {};
  return poses;
}

std::vector<TrianglePair> overlap_under_variations(const Mesh& a, const Mesh& b) {
  Pairs expected = reference::overlap(a, {}, b, {}).pairs;
  for_each_variation(a, b, [&](const Variation& variation) {
    expect_pairs(overlap(variation.a, variation.b, {}, variation.limits),
                 renamed(expected, variation), variation.what);
  });
  vary_traversals(a, b, expected);
  vary_modes(a, b, expected);
  vary_batch(a, b, expected);
  return expected;
}

void expect_overlap(const Mesh& a, const Mesh& b, bool expected) {
  EXPECT_EQ(!overlap_under_variations(a, b).empty(), expected);
}

Distance distance_under_variations(const Mesh& a, const Mesh& b) {
  const PairTruth truth = truth_of(Body(a), Body(b));
  for_each_variation(a, b, [&](const Variation& variation) {
    expect_near(variation, truth_for(variation, truth));
  });
  expect_near_in_batch(a, b, truth);
  return truth.distance;
}

void expect_distance(const Mesh& a, const Mesh& b, const Bracket& expected) {
  EXPECT_EQ(distance_under_variations(a, b).distance, expected);
}

}  // namespace soms::test
