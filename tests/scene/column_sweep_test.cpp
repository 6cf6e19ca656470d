#include "soms/scene/detail/column_sweep.h"

#include "soms/scene/reference/broad_phase.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {

namespace {

std::vector<detail::FloatBox> as_floats(const std::vector<Box>& boxes) {
  const detail::FloatMap map = detail::FloatMap::of(boxes);
  std::vector<detail::FloatBox> floats;
  for (const Box& box : boxes) {
    floats.push_back(box.empty() ? detail::kNoBox : map(box));
  }
  return floats;
}

TEST(FloatMap, KeepsBoxesMeetingThatMeet) {
  test::for_each_case("scene/float-map", 100, [](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    const std::vector<detail::FloatBox> floats = as_floats(boxes);
    for (const auto& [a, b] : reference::meeting_pairs(boxes)) {
      ASSERT_TRUE(detail::meet(floats[a], floats[b]));
    }
    for (const detail::FloatBox& box : floats) {
      ASSERT_TRUE(detail::holds(box, box));
    }
  });
}

TEST(ColumnSweep, GiveEachPairOnceAndMissNone) {
  detail::ColumnSweep column_sweep;  // reused: what an earlier call left must not show
  int grids = 0;
  test::for_each_case("scene/columns", 300, [&](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    const auto found = column_sweep.find(as_floats(boxes));
    if (!found) {
      return;
    }
    ++grids;
    std::vector<std::uint64_t> pairs(found->begin(), found->end());
    std::sort(pairs.begin(), pairs.end());
    ASSERT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [a, b] : reference::meeting_pairs(boxes)) {
      ASSERT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::uint64_t{a} << 32 | b));
    }
  });
  EXPECT_GT(grids, 200);
}

// A size of endless less endless is no number: all boxes would share one column.
TEST(ColumnSweep, FindAGridBesideBoxesBeyondTheRangeOfFloats) {
  std::vector<Box> boxes;
  for (int y = 0; y < 40; ++y) {
    for (int z = 0; z < 40; ++z) {
      boxes.push_back({{0, 2.0 * y, 2.0 * z}, {1, 2.0 * y + 1, 2.0 * z + 1}});
    }
  }
  for (std::size_t k = 0; k < boxes.size(); k += 260) {
    boxes[k] = {{0x1p299, 0x1p299, 0x1p299}, {0x1p299, 0x1p299, 0x1p299}};
  }
  detail::ColumnSweep column_sweep;
  const auto found = column_sweep.find(as_floats(boxes));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 7U * 6 / 2);
}

TEST(ColumnSweep, DeclineBoxesThatDoNotSuitAGrid) {
  detail::ColumnSweep column_sweep;
  std::vector<Box> equal(1000, Box{{0, 0, 0}, {1, 1, 1}});
  EXPECT_FALSE(column_sweep.find(as_floats(equal)));
  const std::vector<Box> empty(1000);
  EXPECT_FALSE(column_sweep.find(as_floats(empty)));
}

}  // namespace

}  // namespace soms
