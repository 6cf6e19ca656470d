#include "soms/scene/detail/column_sweep.h"

#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/scene/reference/broad_phase.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
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

// As for answers: floats that differ, and an empty box.
TEST(FloatMap, SaysOfBoxesWhatTheirEndsAre) {
  test::for_each_case("scene/float-map/verdicts", 100, [](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    const std::vector<detail::FloatBox> floats = as_floats(boxes);
    const detail::FloatMap map = detail::FloatMap::of(boxes);
    for (std::size_t a = 0; a < boxes.size(); ++a) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(map(boxes[a]).lower[axis], floats[a].lower[axis]);
        ASSERT_EQ(map(boxes[a]).upper[axis], floats[a].upper[axis]);
      }
      const std::size_t b = rng.below(boxes.size());
      const detail::FloatVerdict verdict = detail::compare(floats[a], floats[b]);
      ASSERT_TRUE(verdict.meet || !overlaps(boxes[a], boxes[b]));
      ASSERT_TRUE(!verdict.sure || overlaps(boxes[a], boxes[b]));
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
    std::vector<std::uint64_t> pairs;
    for (const std::uint64_t pair : *found) {
      pairs.push_back(pair & ~detail::kOpenPair);
    }
    std::sort(pairs.begin(), pairs.end());
    ASSERT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [a, b] : reference::meeting_pairs(boxes)) {
      ASSERT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::uint64_t{a} << 32 | b));
    }
  });
  EXPECT_GT(grids, 200);
}

/// All kernels of this processor, by their names.
std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const detail::Kernels* kernels : detail::kernels_here()) {
    names.emplace_back(kernels->name);
  }
  return names;
}

/// Boxes whose ends are whole numbers, so that many coincide.
std::vector<Box> boxes_side_by_side(Rng& rng) {
  std::vector<Box> boxes;
  const auto whole = [&](std::uint64_t below) { return static_cast<double>(rng.below(below)); };
  const std::uint64_t side = 4 + rng.below(20);
  for (std::uint64_t k = rng.below(400); k > 0; --k) {
    const Vec3 lower{whole(side), whole(side), whole(side)};
    boxes.push_back({lower, lower + Vec3{whole(3), whole(3), whole(3)}});
  }
  return boxes;
}

// The bit of an open pair is all that may differ from what doubles say, and only where ends meet.
TEST(ColumnSweep, AreSureOfPairsWhoseInsidesMeetByEachInstructionSet) {
  std::size_t sure = 0;
  std::size_t open = 0;
  test::for_each_case("scene/columns/sure", 300, [&](Rng& rng) {
    const std::vector<Box> boxes =
        rng.below(2) == 0 ? boxes_side_by_side(rng) : test::random_boxes(rng);
    for (const std::string& name : instruction_sets()) {
      detail::ColumnSweep column_sweep(detail::sweep_kernel(name));
      const auto found = column_sweep.find(as_floats(boxes));
      for (const std::uint64_t pair : found.value_or(std::span<std::uint64_t>())) {
        const Box& a = boxes[(pair & ~detail::kOpenPair) >> 32];
        const Box& b = boxes[static_cast<std::uint32_t>(pair)];
        if ((pair & detail::kOpenPair) != 0) {
          ++open;
          continue;
        }
        ++sure;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          ASSERT_LT(a.lower[axis], b.upper[axis]) << name;
          ASSERT_LT(b.lower[axis], a.upper[axis]) << name;
        }
      }
    }
  });
  EXPECT_GT(sure, 10000U);
  EXPECT_GT(open, 10000U);
}

TEST(ColumnSweep, FindTheSameInTheSameOrderByEachInstructionSet) {
  test::for_each_case("scene/columns/kernels", 200, [](Rng& rng) {
    const std::vector<Box> boxes =
        rng.below(2) == 0 ? boxes_side_by_side(rng) : test::random_boxes(rng);
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < boxes.size() && rng.below(200) != 0; ++k) {
      groups.push_back(static_cast<std::uint32_t>(rng.below(4)));
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ignored;
    for (std::uint64_t k = rng.below(2) * rng.below(200); k > 0 && boxes.size() > 1; --k) {
      const auto a = static_cast<std::uint32_t>(rng.below(boxes.size() - 1));
      ignored.emplace_back(a, a + 1);
    }
    for (const bool filtered : {false, true}) {
      const detail::PairFilter filter =
          filtered ? detail::PairFilter(groups, ignored) : detail::PairFilter();
      detail::ColumnSweep plain(detail::sweep_by_fours);
      const auto expected = plain.find(as_floats(boxes), filter);
      for (const std::string& name : instruction_sets()) {
        detail::ColumnSweep column_sweep(detail::sweep_kernel(name));
        const auto found = column_sweep.find(as_floats(boxes), filter);
        ASSERT_EQ(found.has_value(), expected.has_value()) << name;
        if (found) {
          ASSERT_TRUE(std::equal(found->begin(), found->end(), expected->begin(), expected->end()))
              << name;
        }
      }
    }
  });
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
