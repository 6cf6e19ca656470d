// Floats must not drop what is exactly as near as the limit: keys of nodes, slabs, boxes of
// triangles, and bounds of triangles, each by itself.
#include "soms/query/detail/kernels/instruction_set.h"

#include "tests/query/margins/gap.h"
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

}  // namespace
}  // namespace soms::detail
