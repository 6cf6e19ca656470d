// Relations that hold between distances, whatever the bodies.
#include "soms/query/distance.h"

#include "soms/base/random.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/distance.h"
#include "soms/query/within.h"

#include "tests/properties/meshes.h"
#include "tests/properties/near_touch.h"
#include "tests/properties/property.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/shortest_segment.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::check_property;
using test::lattice_corners;
using test::lattice_mesh;
using test::mapped;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double above(double x) {
  return std::nextafter(x, kInfinity);
}

/// A mesh with at least one triangle, on a lattice.
Mesh some_mesh(double unit) {
  Mesh mesh = lattice_mesh(*lattice_corners(), unit);
  return mesh.triangles.empty() ? lattice_mesh({0, 1, 9}, unit) : mesh;
}

/// `mesh` moved by whole units so that it may or may not meet what lies on the lattice itself.
Mesh moved_by_units(const Mesh& mesh, double unit) {
  const auto steps = rc::gen::inRange<int>(-24, 24);
  const Vec3 by =
      Vec3{static_cast<double>(*steps), static_cast<double>(*steps), static_cast<double>(*steps)} *
      unit;
  return mapped(mesh, [&](const Vec3& v) { return v + by; });
}

Bracket distance_of(const Mesh& a, const Mesh& b) {
  return distance(Body(a), Body(b)).distance;
}

TEST(DistanceProperty, LatticesAnswerAsBruteForce) {
  check_property("distance/lattice", [] {
    const Body a(lattice_mesh(*lattice_corners(), 0x1p-20));
    const Body b(moved_by_units(lattice_mesh(*lattice_corners(), 0x1p-20), 0x1p-20));
    RC_ASSERT(test::first_fault(a, b) == "");
  });
}

TEST(DistanceProperty, EveryKindOfBodyAnswersAsBruteForce) {
  check_property("distance/kinds", [](std::uint64_t seed) {
    const int kind = *rc::gen::inRange(0, test::kBodyKinds);
    Rng rng(seed);
    const auto [a, b] = test::meshes_of_kind(kind, rng);
    const double reach = test::is_tiny(kind) ? 0x1p-70 : *rc::gen::element(0.5, 4.0, 1e6);
    const Pose pose = test::touches_in_place(kind) ? Pose{} : test::any_pose(rng, reach);
    RC_ASSERT(test::first_fault(Body(a), Body(b, pose)) == "");
  });
}

// Poses off orthonormal by what is allowed, beside each other and far away.
TEST(DistanceProperty, PosesThatAreOffAnswerAsBruteForce) {
  check_property("distance/poses", [](std::uint64_t seed) {
    Rng rng(seed);
    const auto [a, b] = test::meshes_of_kind(0, rng);
    Pose pose_a = test::awkward_rotation(rng);
    Pose pose_b = test::awkward_rotation(rng);
    const double reach = *rc::gen::element(0.5, 3.0, 100.0, 1e8);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double shared = *rc::gen::element(0.0, 1e7);
      pose_a.m[4 * axis + 3] = shared;
      pose_b.m[4 * axis + 3] = shared + rng.uniform(-reach, reach);
    }
    RC_ASSERT(test::first_fault(Body(a, pose_a), Body(b, pose_b)) == "");
  });
}

TEST(DistanceProperty, TrianglesThatNearlyTouchAnswerAsBruteForce) {
  test::for_each_case("distance/near-touch", 300, [](Rng& rng) {
    std::vector<Triangle> first;
    std::vector<Triangle> second;
    for (int i = 0; i < 3; ++i) {
      const auto [s, t] = test::nearly_touching(rng);
      first.push_back(s);
      second.push_back(t);
    }
    ASSERT_EQ(test::first_fault(Body(test::soup_body(first)), Body(test::soup_body(second))), "");
    ASSERT_EQ(test::first_fault(test::body_of(first[0]), test::body_of(second[0])), "");
  });
}

TEST(DistanceProperty, ExchangingTheBodiesKeepsTheBracket) {
  check_property("distance/exchange", [](std::uint64_t seed) {
    Rng rng(seed);
    const auto [a, b] = test::meshes_of_kind(*rc::gen::inRange(0, test::kBodyKinds), rng);
    const Pose pose = test::any_pose(rng, 3);
    const Distance there = distance(Body(a), Body(b, pose));
    const Distance back = distance(Body(b, pose), Body(a));
    RC_ASSERT(there.distance == back.distance);
    if (there.triangles) {
      // Each names a pair that is as near; of equally near ones each the least in its own order.
      RC_ASSERT(*there.triangles <= (TrianglePair{back.triangles->b, back.triangles->a}));
      RC_ASSERT(*back.triangles <= (TrianglePair{there.triangles->b, there.triangles->a}));
    }
  });
}

TEST(DistanceProperty, RotationsOfTheCubeChangeNothing) {
  check_property("distance/rotations", [] {
    const Mesh a = some_mesh(0x1p-3);
    const Mesh b = moved_by_units(some_mesh(0x1p-3), 0x1p-3);
    const Distance expected = distance(Body(a), Body(b));
    for (const Pose& turn : test::cube_rotations()) {
      const auto rotate = [&](const Vec3& v) { return turn.apply(v); };
      const Distance turned = distance(Body(mapped(a, rotate)), Body(mapped(b, rotate)));
      const Distance posed = distance(Body(a, turn), Body(b, turn));
      RC_ASSERT(turned.distance == expected.distance);
      RC_ASSERT(turned.triangles == expected.triangles);
      RC_ASSERT(posed.distance == expected.distance);
      RC_ASSERT(posed.triangles == expected.triangles);
    }
  });
}

TEST(DistanceProperty, PowersOfTwoScaleIt) {
  check_property("distance/powers", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh a = some_mesh(0.125);
    const Pose pose = test::any_pose(rng, 6);
    const Mesh b = mapped(some_mesh(0.125), [&](const Vec3& v) { return pose.apply(v); });
    const Distance expected = distance(Body(a), Body(b));
    const int k = *rc::gen::inRange(-280, 280);
    const auto scale = [&](const Vec3& v) { return v * std::ldexp(1.0, k); };
    const Distance scaled = distance(Body(mapped(a, scale)), Body(mapped(b, scale)));
    RC_ASSERT(scaled.distance.lower == std::ldexp(expected.distance.lower, k));
    RC_ASSERT(scaled.distance.upper == std::ldexp(expected.distance.upper, k));
    RC_ASSERT(scaled.triangles == expected.triangles);
  });
}

// On a grid, shifts round nothing, so the distance changes by at most their length.
TEST(DistanceProperty, AShiftChangesItByAtMostItsLength) {
  check_property("distance/lipschitz", [] {
    const Mesh a = some_mesh(0x1p-4);
    const Mesh b = moved_by_units(some_mesh(0x1p-4), 0x1p-4);
    const auto steps = rc::gen::inRange<int>(-300, 300);
    const Vec3 by = Vec3{static_cast<double>(*steps), static_cast<double>(*steps),
                         static_cast<double>(*steps)} *
                    0x1p-9;
    const double length = above(std::sqrt(dot(by, by)));
    const Bracket before = distance_of(a, b);
    const Bracket after = distance(Body(a), Body(b, Pose::translation(by.x, by.y, by.z))).distance;
    RC_ASSERT(after.lower <= above(before.upper + length));
    RC_ASSERT(before.lower <= above(after.upper + length));
  });
}

TEST(DistanceProperty, ItIsZeroExactlyWhereTheBodiesOverlap) {
  std::size_t touching = 0;
  std::size_t apart = 0;
  check_property("distance/zero", [&](std::uint64_t seed) {
    Rng rng(seed);
    const auto [a, b] = test::meshes_of_kind(*rc::gen::inRange(0, test::kBodyKinds), rng);
    const Body x(a);
    const Body y(b, rng.below(2) == 0 ? Pose{} : test::any_pose(rng, 1));
    const Overlap pairs = overlap(x, y, {.mode = OverlapMode::first});
    const Distance near = distance(x, y);
    RC_ASSERT((near.distance.upper == 0) == pairs.any);
    RC_ASSERT(within(x, y, 0).within == pairs.any);
    if (pairs.any) {
      RC_ASSERT(near.triangles == pairs.pairs.front());
    }
    ++(pairs.any ? touching : apart);
  });
  EXPECT_GT(touching, 50U);
  EXPECT_GT(apart, 50U);
}

TEST(DistanceProperty, ALimitGivesTheSameAnswerOrFarther) {
  check_property("distance/at-most", [](std::uint64_t seed) {
    Rng rng(seed);
    const auto [a, b] = test::meshes_of_kind(*rc::gen::inRange(0, test::kBodyKinds), rng);
    const Body x(a);
    const Body y(b, test::any_pose(rng, 3));
    const Distance whole = distance(x, y);
    RC_PRE(whole.triangles.has_value());
    const double limit = whole.distance.upper * std::exp2(rng.uniform(-1, 1));
    Distance limited = distance(x, y, {.at_most = limit});
    const Within near = within(x, y, limit);
    RC_ASSERT(near.within == (whole.distance.upper <= limit));
    RC_ASSERT(limited.farther == !near.within);
    if (limited.farther) {
      RC_ASSERT(limited.distance.lower >= limit);
      RC_ASSERT(limited.distance.lower <= whole.distance.lower);
      RC_ASSERT(limited.distance.upper == kInfinity);
      RC_ASSERT(!limited.triangles);
    } else {
      limited.cost = whole.cost;
      RC_ASSERT(limited == whole);
    }
  });
}

// Through any point, the two distances to it are no shorter than the least distance.
TEST(DistanceProperty, ItIsAtMostTheSumThroughAPoint) {
  check_property("distance/through-a-point", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh a = some_mesh(0.25);
    const Mesh b = moved_by_units(some_mesh(0.25), 0.25);
    const auto coordinate = [&] { return rng.uniform(-4, 4); };
    const Vec3 p{coordinate(), coordinate(), coordinate()};
    const Body point = test::body_of({p, p, p});
    const double to = distance(Body(a), point).distance.upper;
    const double from = distance(point, Body(b)).distance.upper;
    RC_ASSERT(distance_of(a, b).lower <= above(to + from));
  });
}

// Without a triangle nothing comes nearer, and without one that is not the nearest nothing changes.
TEST(DistanceProperty, RemovingATriangleBringsNothingNearer) {
  check_property("distance/removal", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh a = some_mesh(0.25);
    const Body b(moved_by_units(some_mesh(0.25), 0.25), test::any_pose(rng, 1));
    const Distance whole = distance(Body(a), b);
    const auto left_out = static_cast<TriangleId>(rng.below(a.triangles.size()));
    Mesh fewer = a;
    fewer.triangles.erase(fewer.triangles.begin() + left_out);
    const Distance rest = distance(Body(fewer), b);
    RC_ASSERT(rest.distance.lower >= whole.distance.lower);
    RC_ASSERT(rest.distance.upper >= whole.distance.upper);
    if (left_out != whole.triangles->a) {
      TrianglePair expected = *whole.triangles;
      expected.a -= left_out < expected.a ? 1 : 0;
      RC_ASSERT(rest.distance == whole.distance);
      RC_ASSERT(rest.triangles == expected);
    }
  });
}

TEST(DistanceProperty, PermutingTrianglesAndCornersKeepsTheBracket) {
  check_property("distance/permute", [](std::uint64_t seed) {
    const Mesh a = some_mesh(0.25);
    const Body b(moved_by_units(some_mesh(0.25), 0.25));
    Rng rng(seed);
    std::vector<TriangleId> order(a.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    Mesh permuted = a;
    for (std::size_t i = 0; i < order.size(); ++i) {
      std::swap(order[i], order[i + rng.below(order.size() - i)]);
      const auto& [p, q, r] = a.triangles[order[i]];
      permuted.triangles[i] = rng.below(2) == 0 ? std::array{q, r, p} : std::array{r, q, p};
    }
    const Distance before = distance(Body(a), b);
    const Distance after = distance(Body(permuted), b);
    RC_ASSERT(after.distance == before.distance);
    RC_ASSERT(test::distance_of_pair(Body(permuted), b, *after.triangles) == before.distance);
    RC_ASSERT(order[after.triangles->a] >= before.triangles->a);
  });
}

// The twin's own answer about a clearance is another route to the same fact.
TEST(DistanceProperty, TheTwinsAgreeWithEachOther) {
  check_property("distance/twins", [](std::uint64_t seed) {
    Rng rng(seed);
    const auto [a, b] = test::meshes_of_kind(*rc::gen::inRange(0, test::kBodyKinds), rng);
    const Body x(a);
    const Body y(b, test::any_pose(rng, 2));
    const Bracket d = reference::distance_by_brute_force(x, y).distance;
    RC_PRE(d.upper < kInfinity);
    RC_ASSERT(reference::within_by_brute_force(x, y, d.upper));
    RC_ASSERT(reference::within_by_brute_force(x, y, d.lower) == (d.lower == d.upper));
    if (d.lower > 0) {
      RC_ASSERT(!reference::within_by_brute_force(x, y, std::nextafter(d.lower, 0)));
    }
  });
}

}  // namespace
}  // namespace soms
