// Floats must not drop what is exactly as near as the limit: keys of nodes, slabs, boxes of
// triangles, and bounds of triangles, each by itself.
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/within.h"

#include "tests/query/margins/gap.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstddef>

namespace soms::detail {
namespace {

struct NearTally {
  std::size_t near = 0;
  std::size_t touching = 0;
};

void expect_kept(const test::Gap& gap, NearTally& tally) {
  test::Seen seen(test::shape_of(gap.x), gap.pose_x, test::shape_of(gap.y), gap.pose_y);
  if (seen.pose.far()) {
    return;
  }
  ++tally.near;
  tally.touching += seen.distance == 0 ? 1 : 0;
  const test::Bounds first = test::bounds_of(seen, scalar::kernels());
  for (const Kernels* kernels : kernels_here()) {
    const test::Bounds bounds = test::bounds_of(seen, *kernels);
    ASSERT_TRUE(bounds.nodes) << kernels->name << ' ' << seen.distance;
    ASSERT_TRUE(bounds.slabs) << kernels->name << ' ' << seen.distance;
    ASSERT_TRUE(bounds.boxes) << kernels->name << ' ' << seen.distance;
    ASSERT_TRUE(bounds.pairs) << kernels->name << ' ' << seen.distance;
    ASSERT_LE(bounds.of_nodes, seen.distance) << kernels->name;
    ASSERT_LE(bounds.of_pairs, seen.distance) << kernels->name;
    ASSERT_EQ(bounds.of_nodes, first.of_nodes) << kernels->name;
    ASSERT_EQ(bounds.of_pairs, first.of_pairs) << kernels->name;
  }
}

TEST(NearFilters, KeepTrianglesAtTheirDistance) {
  NearTally tally;
  test::for_each_case("near-filters/near", 4000, [&](Rng& rng) {
    ASSERT_NO_FATAL_FAILURE(expect_kept(test::random_gap(rng, 2), tally));
  });
  EXPECT_GT(tally.near, 3000U);
}

TEST(NearFilters, KeepTrianglesAtTheirDistanceFarFromTheOrigin) {
  NearTally tally;
  test::for_each_case("near-filters/far", 3000, [&](Rng& rng) {
    ASSERT_NO_FATAL_FAILURE(
        expect_kept(test::random_gap(rng, std::exp2(rng.uniform(1, 100))), tally));
  });
  EXPECT_GT(tally.near, 2000U);
}

// What limits grant beside is for the offset of nodes: lengths of gaps are shortened by all else.
TEST(NearFilters, LengthsNeedNothingOfTheLimit) {
  constexpr double kSize = 0x1p-30;
  const Shape point = test::shape_of({{kSize, 0, 0}, {0, kSize, 0}, {0, 0, kSize}});
  test::for_each_case("near-filters/lengths", 300, [&](Rng& rng) {
    Pose pose_x = test::awkward_rotation(rng);
    if (rng.below(2) == 0) {
      pose_x = {};
      for (const std::size_t entry : {0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) {
        pose_x.m[entry] += 0.4999e-6;
      }
    }
    const Vec3 way = rng.below(2) == 0
                         ? Vec3{1, 1, 1}
                         : Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const test::Seen seen(point, test::moving(pose_x, {}, way), point, {});
    NodeTask task = {};
    task.pose = &seen.pose.numbers();
    task.x = seen.frame.x().layout().nodes().data();
    task.y = seen.frame.y().layout().nodes().data();
    task.pairs = 1;
    NodeKeys keys;
    scalar::kernels().bound_nodes(&task, 1, 0, &keys);
    ASSERT_LE(keys.key[0], seen.distance * seen.pose.numbers().scale);
  });
}

/// A body of two leaves: a triangle, and one of size 1 far from it, by which layouts are scaled.
Body beside_a_large_one(const Triangle& t, double side) {
  const Vec3 p{side * 8, side * 8, 8};
  ShapeOptions options;
  options.build.per_leaf = 1;
  return Body(Shape(test::soup_body({t, {p, p + Vec3{1, 0, 0}, p + Vec3{0, 1, 0}}}), options));
}

// A corner in common, in one plane: products of the smaller one's normal underflow.
TEST(NearFilters, KeepTrianglesWhoseProductsUnderflow) {
  test::for_each_case("near-filters/underflow", 1000, [](Rng& rng) {
    const auto any = [&] {
      return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    const double size = std::exp2(-rng.uniform(25, 35));
    const double tiny = std::exp2(-rng.uniform(53, 66));
    const Vec3 p = size * any();
    const Vec3 e = any();
    const Vec3 f = any();
    const Triangle large{p, p + size * e, p + size * f};
    const Triangle small{p, p - tiny * e, p - tiny * f};
    const Body a = beside_a_large_one(large, 1);
    const Body b = beside_a_large_one(small, -1);
    ASSERT_TRUE(within(a, b, 0).within);
    ASSERT_TRUE(within(b, a, 0).within);
  });
}

}  // namespace
}  // namespace soms::detail
