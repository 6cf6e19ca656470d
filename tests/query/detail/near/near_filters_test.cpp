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

/// A body of three leaves: a triangle, and points at `q` and -q, by which layouts are scaled.
Body between_points(const Triangle& t, const Vec3& q) {
  ShapeOptions options;
  options.build.per_leaf = 1;
  return Body(Shape(test::soup_body({t, {q, q, q}, {-q, -q, -q}}), options));
}

void expect_touching(const Triangle& large, const Triangle& small) {
  const Body a = between_points(large, {-1, -2, 0.75});
  const Body b = between_points(small, {1, 2, 1.25});
  EXPECT_TRUE(within(a, b, 0).within);
  EXPECT_TRUE(within(b, a, 0).within);
}

// The smaller one is across the other. Products of its normal, 2^-116, and the other's corners,
// 2^-31, are a few of the least floats, and seem to be apart by one more.
TEST(NearFilters, KeepTrianglesWhoseProductsUnderflow) {
  expect_touching({{-0x1.2947056d3edp-31, 0x1.5d6085de01ff4p-31, 0x1.2a20f67c02fdp-34},
                   {-0x1.c51ced56fec16p-31, -0x1.0ebbef78efdfp-32, -0x1.6aeb83ff777fp-33},
                   {-0x1.109a3fd944958p-32, -0x1.cb7765ff1215p-32, -0x1.197821ad7490ep-31}},
                  {{-0x1.89d59a525c8fep-31, -0x1.923e7aa54642cp-33, -0x1.a20a6ed502dd3p-33},
                   {-0x1.89d59a48bf044p-31, -0x1.923e7b597abdp-33, -0x1.a20a6f3632fb6p-33},
                   {-0x1.89d59a21147f7p-31, -0x1.923e7b1e745b8p-33, -0x1.a20a6f4e48d5bp-33}});
  expect_touching({{0x1.f62ab217863d4p-32, -0x1.350ed1d5480c8p-31, -0x1.2d5aa80413bf4p-32},
                   {-0x1.2e2b06a0777fp-31, -0x1.db7c72e562644p-32, -0x1.9fbff170976ap-31},
                   {-0x1.9d2f6c17f3f5p-34, -0x1.82cae44b31e18p-33, 0x1.fe8bed4c3976ap-31}},
                  {{-0x1.e6d0a0db1b6cp-32, -0x1.a3eb1e9b5d8bep-32, -0x1.be42a6266b0dep-32},
                   {-0x1.e6d0a0fe53dffp-32, -0x1.a3eb1e6e662abp-32, -0x1.be42a5eae9c9ep-32},
                   {-0x1.e6d0a11e63504p-32, -0x1.a3eb1e58dcf28p-32, -0x1.be42a5fe559e1p-32}});
}

}  // namespace
}  // namespace soms::detail
