// Relations of closed bodies, whatever they are.
#include "soms/query/solid.h"

#include "soms/base/random.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/solid.h"

#include "tests/properties/meshes.h"
#include "tests/properties/property.h"
#include "tests/support/bodies.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::check_property;
using test::closed_mesh;
using test::mapped;

constexpr int kManyCases = 20;

Relation exchanged_relation(Relation relation) {
  return relation == Relation::a_in_b   ? Relation::b_in_a
         : relation == Relation::b_in_a ? Relation::a_in_b
                                        : relation;
}

/// A box with corners on a lattice, so that many touch.
Box lattice_box(Rng& rng) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.lower[k] = static_cast<double>(rng.below(4));
    box.upper[k] = box.lower[k] + static_cast<double>(1 + rng.below(3));
  }
  return box;
}

/// What intervals say of two boxes.
Relation relation_of_boxes(const Box& a, const Box& b) {
  if (!overlaps(a, b)) {
    return Relation::clear;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.upper[k] == b.lower[k] || b.upper[k] == a.lower[k]) {
      return Relation::touching;
    }
  }
  const bool in_b = b.contains(a);
  const bool in_a = a.contains(b);
  return in_a ? (in_b ? Relation::same : Relation::b_in_a)
              : (in_b ? Relation::a_in_b : Relation::crossing);
}

TEST(SolidProperty, OfBoxesIsWhatTheirIntervalsSay) {
  check_property("solid/boxes", [](std::uint64_t seed) {
    Rng rng(seed);
    const Box a = lattice_box(rng);
    const Box b = lattice_box(rng);
    const Vec3 shift{std::ldexp(1.0, static_cast<int>(rng.below(40))), 0,
                     -std::ldexp(1.0, static_cast<int>(rng.below(40)))};
    const double unit = std::ldexp(1.0, static_cast<int>(rng.below(80)) - 40);
    const auto placed = [&](const Box& box) {
      return Body(mapped(box_body(box.lower, box.upper, rng.below(2) == 0 ? 1 : 2),
                         [&](const Vec3& v) { return (v + shift) * unit; }));
    };
    const Body body_a = placed(a);
    const Body body_b = placed(b);
    const Solid answer = solid(body_a, body_b);
    RC_ASSERT(answer.relation == relation_of_boxes(a, b));
    RC_ASSERT(answer.surfaces_meet == overlap(body_a, body_b).any);
  });
}

TEST(SolidProperty, AnswersAsBruteForceAndTheOtherWayRound) {
  check_property("solid/twin", [](std::uint64_t seed) {
    Rng rng(seed);
    const Body a(closed_mesh(rng, 3));
    const Vec3 shift{static_cast<double>(rng.below(3)), 0, static_cast<double>(rng.below(2))};
    const Body b(mapped(closed_mesh(rng, 3), [&](const Vec3& v) { return v + shift; }));
    const Solid answer = solid(a, b);
    const Solid truth = reference::solid_by_brute_force(a, b);
    RC_ASSERT(answer.relation == truth.relation);
    RC_ASSERT(answer.surfaces_meet == truth.surfaces_meet);
    RC_ASSERT(solid(b, a).relation == exchanged_relation(answer.relation));
  });
}

/// Boxes on a lattice of 12 x 12 x 3, most of them between heights 1 and 2: far more triangles on
/// one face than anywhere else, which overlap each other too, if `apart` is false.
Mesh many_boxes(Rng& rng, bool apart) {
  Mesh mesh;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Box box;
      const std::array<int, 2> place{i, j};
      for (std::size_t k = 0; k < 2; ++k) {
        box.lower[k] = 4.0 * place[k] + static_cast<double>(rng.below(2));
        box.upper[k] = box.lower[k] + static_cast<double>(1 + rng.below(apart ? 2 : 5));
      }
      box.lower.z = rng.below(40) == 0 ? 0 : 1;
      box.upper.z = rng.below(80) == 0 ? 3 : 2;
      if (rng.below(8) != 0) {
        mesh = test::joined(std::move(mesh),
                            box_body(box.lower, box.upper, rng.below(4) == 0 ? 2 : 1));
      }
    }
  }
  return mesh;
}

/// A box around these, on top or below, that may have one of its own faces where they have theirs.
Mesh slab_at_boxes(Rng& rng) {
  const bool on_top = rng.below(4) != 0;
  const double rim = static_cast<double>(rng.below(4)) - 1;
  return box_body({-rim, -rim, on_top ? 2.0 : 0}, {14 + rim, 14 + rim, on_top ? 3.0 : 1});
}

// Segments are found in boxes here, and edges that part nothing left out.
TEST(SolidProperty, OfManyTrianglesOnOneFaceIsAsBruteForceFinds) {
  test::for_each_case("solid/many", test::some_of(kManyCases), [](Rng& rng) {
    const auto skewed = [&](const Mesh& mesh) {
      return mapped(mesh, [](const Vec3& v) {
        return Vec3{v.x + 2 * v.z, 3 * v.y - v.z, v.z + v.x - 2 * v.y};
      });
    };
    const bool skew = rng.below(2) == 0;
    Mesh a = many_boxes(rng, rng.below(2) == 0);
    Mesh b = slab_at_boxes(rng);
    if (rng.below(3) == 0) {
      b = test::joined(b, many_boxes(rng, true));
    }
    const Body body_a(skew ? skewed(a) : a);
    const Body body_b(skew ? skewed(b) : b);
    const Solid answer = solid(body_a, body_b);
    const Solid truth = reference::solid_by_brute_force(body_a, body_b);
    ASSERT_EQ(answer.relation, truth.relation);
    ASSERT_EQ(answer.surfaces_meet, truth.surfaces_meet);
    ASSERT_EQ(solid(body_b, body_a).relation, exchanged_relation(answer.relation));
  });
}

/// The mesh with its triangles in another order, turned over, and some split in two at the middle
/// of an edge that a double can hold: the same set of points on a lattice.
Mesh cut_otherwise(const Mesh& mesh, Rng& rng) {
  Mesh other = mesh;
  other.triangles.clear();
  for (const auto& t : mesh.triangles) {
    if (rng.below(2) == 0) {
      other.triangles.push_back({t[1], t[0], t[2]});
      continue;
    }
    const auto middle = static_cast<std::uint32_t>(other.vertices.size());
    other.vertices.push_back((mesh.vertices[t[0]] + mesh.vertices[t[1]]) * 0.5);
    other.triangles.push_back({t[0], middle, t[2]});
    other.triangles.push_back({middle, t[1], t[2]});
  }
  std::reverse(other.triangles.begin(), other.triangles.end());
  return other;
}

TEST(SolidProperty, OfOneBodyCutOtherwiseIsSame) {
  check_property("solid/same", [](std::uint64_t seed) {
    Rng rng(seed);
    const Box box = lattice_box(rng);
    const Mesh mesh = mapped(box_body(box.lower, box.upper, 1), [](const Vec3& v) {
      return Vec3{v.x + v.y, v.y - v.z, v.z + 2 * v.x};
    });
    const Mesh other = cut_otherwise(mesh, rng);
    RC_ASSERT(solid(Body(mesh), Body(other)).relation == Relation::same);
    RC_ASSERT(solid(Body(other), Body(mesh)).relation == Relation::same);
  });
}

TEST(SolidProperty, BatchesAreSingleQueries) {
  check_property("solid/batch", [](std::uint64_t seed) {
    Rng rng(seed);
    const ClosedBody mover{Body(closed_mesh(rng, 3))};
    const ClosedBody fixed{Body(closed_mesh(rng, 3))};
    std::vector<Pose> poses;
    for (int i = 0; i < 5; ++i) {
      poses.push_back(Pose::translation(static_cast<double>(rng.below(4)), 0, rng.uniform(-1, 1)));
    }
    const SolidBatch batch = solid(mover, poses, fixed);
    RC_ASSERT(solid(mover, poses, fixed, {.threads = 2}) == batch);
    Cost cost;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (batch.why[i] != Undecided::open) {
        RC_ASSERT(solid(mover.at(poses[i]), fixed) == batch.at(i));
      }
      cost += batch.costs[i];
    }
    RC_ASSERT(batch.cost == cost);
  });
}

}  // namespace
}  // namespace soms
