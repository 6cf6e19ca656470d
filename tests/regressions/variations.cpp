#include "tests/regressions/variations.h"

#include "soms/base/random.h"
#include "soms/query/reference/overlap.h"
#include "soms/query/traversal/traversals.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/bodies.h"

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

/// The 24 rotations of the cube: signed permutations of determinant 1.
std::vector<Pose> cube_rotations() {
  std::vector<Pose> rotations;
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Pose pose;
      pose.m.fill(0);
      for (std::size_t row = 0; row < 3; ++row) {
        pose.m[4 * row + order[row]] = (signs >> row & 1U) != 0 ? -1 : 1;
      }
      const Vec3 x = pose.apply({1, 0, 0});
      const Vec3 y = pose.apply({0, 1, 0});
      const Vec3 z = pose.apply({0, 0, 1});
      if (dot(cross(x, y), z) > 0) {
        rotations.push_back(pose);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}

/// The mesh after `there`, or nothing if `back` does not restore every vertex.
template <class There, class Back>
std::optional<Mesh> exactly_mapped(const Mesh& mesh, const There& there, const Back& back) {
  Mesh changed = mapped(mesh, there);
  return mapped(changed, back).vertices == mesh.vertices ? std::optional(changed) : std::nullopt;
}

void expect_pairs(const Body& a, const Body& b, const Pairs& expected, const std::string& what,
                  const OverlapOptions& options = {}, int threads = 1) {
  Parallel parallel;
  parallel.threads = threads;
  const Overlap answer = overlap(a, b, options, parallel);
  EXPECT_EQ(answer.any, !expected.empty()) << what;
  EXPECT_EQ(answer.pairs, expected) << what;
  EXPECT_EQ(answer.coverage, Coverage::complete) << what;
}

void vary_vertices(const Mesh& a, const Mesh& b, const Pairs& expected) {
  for (const Pose& turn : cube_rotations()) {
    const auto rotate = [&turn](const Vec3& v) { return turn.apply(v); };
    expect_pairs(Body(mapped(a, rotate)), Body(mapped(b, rotate)), expected, "rotated vertices");
    expect_pairs(Body(a, turn), Body(b, turn), expected, "rotated by pose");
  }
  for (int k = -40; k <= 40; ++k) {
    const auto scaled = [k](int sign) {
      return [k, sign](const Vec3& v) { return v * std::ldexp(1.0, sign * k); };
    };
    const auto scaled_a = exactly_mapped(a, scaled(1), scaled(-1));
    const auto scaled_b = exactly_mapped(b, scaled(1), scaled(-1));
    if (scaled_a && scaled_b) {
      expect_pairs(Body(*scaled_a), Body(*scaled_b), expected, "scaled by 2^" + std::to_string(k));
    }
  }
  const Vec3 shift{0x1p20, -0x1p21, 0x1p19};
  const auto there = [&](const Vec3& v) { return v + shift; };
  const auto back = [&](const Vec3& v) { return v - shift; };
  const auto far_a = exactly_mapped(a, there, back);
  const auto far_b = exactly_mapped(b, there, back);
  if (far_a && far_b) {
    expect_pairs(Body(*far_a), Body(*far_b), expected, "shifted");
    const Pose pose = Pose::translation(shift.x, shift.y, shift.z);
    expect_pairs(Body(a, pose), Body(b, pose), expected, "shifted by pose");
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

void vary_order(const Mesh& a, const Mesh& b, const Pairs& expected) {
  Pairs swapped;
  for (const auto& [i, j] : expected) {
    swapped.emplace_back(j, i);
  }
  std::sort(swapped.begin(), swapped.end());
  expect_pairs(Body(b), Body(a), swapped, "swapped");
  const Shuffled x = shuffled(a, 1);
  const Shuffled y = shuffled(b, 2);
  Pairs renamed;
  for (const auto& [i, j] : expected) {
    renamed.emplace_back(x.place[i], y.place[j]);
  }
  std::sort(renamed.begin(), renamed.end());
  expect_pairs(Body(x.mesh), Body(y.mesh), renamed, "permuted");
}

void vary_machinery(const Mesh& a, const Mesh& b, const Pairs& expected) {
  for (const RuleEntry& rule : rules()) {
    for (const int leaf : {1, 4, 1000}) {
      ShapeOptions options;
      options.build.rule = rule.rule;
      options.build.per_leaf = leaf;
      expect_pairs(Body(Shape(a, options)), Body(Shape(b, options)), expected,
                   std::string(rule.name) + ", leaves of " + std::to_string(leaf));
      options.layout = Layout::compact;
      expect_pairs(Body(Shape(a, options)), Body(Shape(b, options)), expected,
                   std::string(rule.name) + ", compact, leaves of " + std::to_string(leaf));
    }
  }
  ShapeOptions kept;
  kept.keep_tree = true;
  const Body body_a{Shape(a, kept)};
  const Body body_b{Shape(b, kept)};
  for (const TraversalEntry& entry : traversals()) {
    OverlapOptions options;
    options.traversal.traversal = entry.traversal;
    expect_pairs(body_a, body_b, expected, std::string(entry.name), options);
  }
  for (const int threads : {2, 8}) {
    expect_pairs(body_a, body_b, expected, std::to_string(threads) + " threads", {}, threads);
  }
}

void vary_modes(const Mesh& a, const Mesh& b, const Pairs& expected) {
  for (const int threads : {1, 2}) {
    Parallel parallel;
    parallel.threads = threads;
    OverlapOptions options;
    options.mode = OverlapMode::any;
    const Overlap any = overlap(Body(a), Body(b), options, parallel);
    EXPECT_EQ(any.any, !expected.empty());
    EXPECT_EQ(any.pairs.size(), expected.empty() ? 0U : 1U);
    for (const TrianglePair& pair : any.pairs) {
      EXPECT_TRUE(std::binary_search(expected.begin(), expected.end(), pair));
    }
    options.mode = OverlapMode::first;
    const Overlap first = overlap(Body(a), Body(b), options, parallel);
    EXPECT_EQ(first.pairs, Pairs(expected.begin(), expected.begin() + (expected.empty() ? 0 : 1)));
  }
}

/// The case as pose 777 of 1000: the others only fill the batch.
void vary_batch(const Mesh& a, const Mesh& b, const Pairs& expected) {
  constexpr std::size_t kPlace = 777;
  const Vec3 size = bounds(a).extent();
  Rng rng(3);
  std::vector<Pose> poses(1000);
  for (Pose& pose : poses) {
    pose = Pose::about_z(
        rng.uniform(-3, 3),
        {size.x * rng.uniform(-1, 1), size.y * rng.uniform(-1, 1), size.z * rng.uniform(-1, 1)});
  }
  poses[kPlace] = {};
  for (const int threads : {1, 2}) {
    Parallel parallel;
    parallel.threads = threads;
    const OverlapBatch batch = overlap(Shape(a), poses, Body(b), {}, parallel);
    ASSERT_EQ(batch.size(), poses.size());
    const auto pairs = batch.pairs_of(kPlace);
    EXPECT_EQ(Pairs(pairs.begin(), pairs.end()), expected) << "in a batch";
    EXPECT_EQ(batch.any[kPlace] != 0, !expected.empty()) << "in a batch";
  }
}

}  // namespace

std::vector<TrianglePair> overlap_under_variations(const Mesh& a, const Mesh& b) {
  Pairs expected = reference::overlap(a, {}, b, {}).pairs;
  expect_pairs(Body(a), Body(b), expected, "as given");
  vary_vertices(a, b, expected);
  vary_order(a, b, expected);
  vary_machinery(a, b, expected);
  vary_modes(a, b, expected);
  vary_batch(a, b, expected);
  return expected;
}

void expect_overlap(const Mesh& a, const Mesh& b, bool expected) {
  EXPECT_EQ(!overlap_under_variations(a, b).empty(), expected);
}

}  // namespace soms::test
