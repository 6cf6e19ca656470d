// Relations that hold between answers, whatever the bodies.
#include "soms/query/overlap.h"

#include "soms/base/random.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/reference/overlap.h"

#include "tests/properties/meshes.h"
#include "tests/properties/near_touch.h"
#include "tests/properties/property.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

namespace soms {
namespace {

using Pairs = std::vector<TrianglePair>;
using test::any_pose;
using test::check_property;
using test::lattice_corners;
using test::lattice_mesh;
using test::mapped;

Pairs pairs_of(const Mesh& a, const Mesh& b) {
  return overlap(Body(a), Body(b)).pairs;
}

TEST(OverlapProperty, LatticesAnswerAsBruteForce) {
  check_property("lattice", [] {
    const Mesh a = lattice_mesh(*lattice_corners(), 0x1p-20);
    const Mesh b = lattice_mesh(*lattice_corners(), 0x1p-20);
    RC_ASSERT(pairs_of(a, b) == reference::overlap(a, {}, b, {}).pairs);
  });
}

TEST(OverlapProperty, SwappingTheBodiesSwapsTheColumns) {
  check_property("swap", [] {
    const Mesh a = lattice_mesh(*lattice_corners(), 1);
    const Mesh b = lattice_mesh(*lattice_corners(), 1);
    Pairs swapped;
    for (const auto& [j, i] : pairs_of(b, a)) {
      swapped.emplace_back(i, j);
    }
    std::sort(swapped.begin(), swapped.end());
    RC_ASSERT(pairs_of(a, b) == swapped);
  });
}

TEST(OverlapProperty, PermutingTrianglesPermutesThePairs) {
  check_property("permute", [](std::uint64_t seed) {
    const Mesh a = lattice_mesh(*lattice_corners(), 1);
    const Mesh b = lattice_mesh(*lattice_corners(), 1);
    Rng rng(seed);
    std::vector<TriangleId> order(a.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    Mesh permuted = a;
    for (std::size_t i = 0; i < order.size(); ++i) {
      std::swap(order[i], order[i + rng.below(order.size() - i)]);
      const auto& [p, q, r] = a.triangles[order[i]];
      permuted.triangles[i] = rng.below(2) == 0 ? std::array{q, r, p} : std::array{r, q, p};
    }
    Pairs renamed;
    for (const auto& [i, j] : pairs_of(permuted, b)) {
      renamed.emplace_back(order[i], j);
    }
    std::sort(renamed.begin(), renamed.end());
    RC_ASSERT(pairs_of(a, b) == renamed);
  });
}

// On a grid of 2^-20 a common shift of up to 2^20 rounds nothing, so nothing may change.
TEST(OverlapProperty, ACommonShiftOnAGridChangesNothing) {
  check_property("shift", [] {
    const Mesh a = lattice_mesh(*lattice_corners(), 0x1p-20);
    const Mesh b = lattice_mesh(*lattice_corners(), 0x1p-20);
    const auto steps =
        rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 40), std::int64_t{1} << 40);
    const auto shift = [](std::int64_t n) { return static_cast<double>(n) * 0x1p-20; };
    const Vec3 by{shift(*steps), shift(*steps), shift(*steps)};
    const Pairs expected = pairs_of(a, b);
    const auto move = [&](const Vec3& v) { return v + by; };
    RC_ASSERT(pairs_of(mapped(a, move), mapped(b, move)) == expected);
    const Pose pose = Pose::translation(by.x, by.y, by.z);
    RC_ASSERT(overlap(Body(a, pose), Body(b, pose)).pairs == expected);
  });
}

Triangle moved(const Pose& pose, const Triangle& t) {
  return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
}

/// True if rounding alone explains that one motion of both triangles changed whether they overlap:
/// where they are apart, before or after, they are no farther than rounding moved them. The motion
/// itself is an exact affine map that changes lengths by less than 2e-6.
bool near_touching(const Pose& pose, const Triangle& s, const Triangle& t) {
  const double apart = triangles_overlap(s, t)
                           ? test::distance_bound(moved(pose, s), moved(pose, t))
                           : test::distance_bound(s, t);
  const double rounding = test::rounding_bound(pose, s) + test::rounding_bound(pose, t);
  return apart <= rounding * (1 + 1e-5);
}

// A rigid motion of both bodies keeps every pair but those that rounding can flip.
TEST(OverlapProperty, ACommonMotionChangesOnlyPairsThatNearlyTouch) {
  std::size_t kept = 0;
  std::size_t changed = 0;
  test::for_each_case("overlap/common-motion", 200, [&](Rng& rng) {
    std::vector<Triangle> first;
    std::vector<Triangle> second;
    for (int i = 0; i < 12; ++i) {
      const auto [s, t] = test::nearly_touching(rng);
      first.push_back(s);
      second.push_back(t);
    }
    const Mesh a = test::soup_body(first);
    const Mesh b = test::soup_body(second);
    const Pose pose = any_pose(rng, rng.below(2) == 0 ? 1 : 1e6);
    const Pairs before = pairs_of(a, b);
    const Pairs after = overlap(Body(a, pose), Body(b, pose)).pairs;
    Pairs difference;
    std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                  std::back_inserter(difference));
    for (const auto& [i, j] : difference) {
      EXPECT_TRUE(near_touching(pose, first[i], second[j])) << i << ' ' << j;
    }
    changed += difference.size();
    kept += before.size();
  });
  EXPECT_GT(changed, 100U);
  EXPECT_GT(kept, 1000U);
}

TEST(OverlapProperty, AnyAndFirstEqualBruteForceOnEveryKindOfBody) {
  check_property("any", [](std::uint64_t seed) {
    const int kind = *rc::gen::inRange(0, test::kBodyKinds);
    Rng rng(seed);
    const auto [a, b] = test::meshes_of_kind(kind, rng);
    // The tiny ones are turned but not carried off, the others are both.
    const Pose pose = any_pose(rng, test::is_tiny(kind) ? 0x1p-70 : 0.5);
    const Pairs expected =
        reference::overlap(a, {}, b, test::touches_in_place(kind) ? Pose{} : pose).pairs;
    const Body x(a);
    const Body y(b, test::touches_in_place(kind) ? Pose{} : pose);
    OverlapOptions options;
    options.mode = OverlapMode::any;
    const Overlap any = overlap(x, y, options);
    RC_ASSERT(any.any == !expected.empty());
    RC_ASSERT(any.pairs.size() == (expected.empty() ? 0U : 1U));
    RC_ASSERT(std::includes(expected.begin(), expected.end(), any.pairs.begin(), any.pairs.end()));
    options.mode = OverlapMode::first;
    const Overlap first = overlap(x, y, options);
    RC_ASSERT(first.any == any.any);
    RC_ASSERT(first.pairs ==
              Pairs(expected.begin(), expected.begin() + (expected.empty() ? 0 : 1)));
    RC_ASSERT(overlap(x, y).pairs == expected);
  });
}

}  // namespace
}  // namespace soms
