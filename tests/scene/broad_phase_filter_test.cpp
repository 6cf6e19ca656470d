#include "soms/base/error.h"
#include "soms/scene/broad_phase.h"
#include "soms/scene/reference/broad_phase.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace soms {

namespace {

/// A filter as its two arguments.
struct Filter {
  std::vector<std::uint32_t> groups;
  std::vector<BoxPair> ignored;
};

Filter random_filter(Rng& rng, std::size_t boxes) {
  Filter filter;
  const std::uint64_t kinds = rng.below(5);  // 0: no groups
  const std::uint64_t most = rng.below(3) == 0 ? boxes / 2 : boxes + 3;
  for (std::uint64_t k = 0; kinds != 0 && k < most; ++k) {
    const std::uint64_t group = rng.below(kinds + 1);
    filter.groups.push_back(static_cast<std::uint32_t>(group == 4 ? 0xffffffffU : group));
  }
  const std::uint64_t ignored = boxes < 2 ? 0 : rng.below(3) * rng.below(100);
  for (std::uint64_t k = 0; k < ignored; ++k) {
    const auto a = static_cast<std::uint32_t>(rng.below(boxes));
    const auto b = static_cast<std::uint32_t>((a + 1 + rng.below(boxes - 1)) % boxes);
    filter.ignored.emplace_back(a, b);
  }
  return filter;
}

std::vector<BoxPair> pairs_of(BroadPhase& phase, const std::vector<Box>& boxes) {
  const auto pairs = phase.find(boxes);
  return {pairs.begin(), pairs.end()};
}

Box moved(const Box& box, const Vec3& by) {
  return box.empty() ? box : Box{box.lower + by, box.upper + by};
}

// All kinds of scatter, coinciding boxes among them, so every way to find pairs is taken.
TEST(BroadPhaseFilter, LeavesOutGroupsAndIgnoredPairsFrameByFrame) {
  std::size_t left_out = 0;
  test::for_each_case("scene/broad-phase/filter", 150, [&](Rng& rng) {
    std::vector<Box> boxes = test::random_boxes(rng);
    Filter filter = random_filter(rng, boxes.size());
    BroadPhase kept;
    BroadPhase fresh;
    kept.set_filter(filter.groups, filter.ignored);
    const Vec3 step{rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), 0};
    for (int frame = 0; frame < 12; ++frame) {
      const auto expected = reference::meeting_pairs(boxes, filter.groups, filter.ignored);
      left_out += reference::meeting_pairs(boxes).size() - expected.size();
      ASSERT_EQ(pairs_of(kept, boxes), expected) << "frame " << frame;
      fresh.forget();
      fresh.set_filter(filter.groups, filter.ignored);
      ASSERT_EQ(pairs_of(fresh, boxes), expected) << "frame " << frame;
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        boxes[k] = moved(boxes[k], step * static_cast<double>(k % 5));
      }
      if (!boxes.empty() && rng.below(3) == 0) {  // one leaves its larger box
        Box& box = boxes[rng.below(boxes.size())];
        box = moved(box, {rng.uniform(-9, 9), 0, 0});
      }
      if (rng.below(4) == 0) {
        filter = random_filter(rng, boxes.size());
        kept.set_filter(filter.groups, filter.ignored);
      }
    }
  });
  EXPECT_GT(left_out, 100000U);
}

TEST(BroadPhaseFilter, OfNoGroupsAndNoPairsLeavesNothingOut) {
  const std::vector<Box> boxes(5, Box{{0, 0, 0}, {1, 1, 1}});
  BroadPhase phase;
  const std::vector<std::uint32_t> groups{7, 7, 7};
  const std::vector<BoxPair> ignored{{4, 3}};
  phase.set_filter(groups, ignored);
  EXPECT_EQ(pairs_of(phase, boxes), reference::meeting_pairs(boxes, groups, ignored));
  phase.set_filter({}, {});
  EXPECT_EQ(pairs_of(phase, boxes).size(), 10U);
  phase.set_filter({0, 0, 0, 0, 0}, {});
  EXPECT_EQ(pairs_of(phase, boxes).size(), 10U);
}

// 4,000 boxes of one group and a few others in one place: the pairs of the few, and no more memory
// than they need. All pairs would take 64 MB as numbers alone.
TEST(BroadPhaseFilter, OfOneGroupInOnePlaceTakesMemoryForOtherPairsAlone) {
  constexpr std::uint32_t kBoxes = 4000;
  const std::vector<Box> boxes(kBoxes, Box{{3, 3, 3}, {4, 4, 4}});
  for (const std::uint32_t others : {0U, 1U, 5U}) {
    std::vector<std::uint32_t> groups(kBoxes, 9);
    for (std::uint32_t k = 0; k < others; ++k) {
      groups[std::size_t{700} * k] = k % 2;  // none or another
    }
    BroadPhase phase;
    phase.set_filter(groups, {});
    const test::AllocationWatch watch;
    for (int frame = 0; frame < 3; ++frame) {
      ASSERT_EQ(pairs_of(phase, boxes), reference::meeting_pairs(boxes, groups)) << others;
    }
    const std::size_t pairs = pairs_of(phase, boxes).size();
    EXPECT_LT(phase.memory(), std::size_t{512} * kBoxes + 128 * pairs);
    EXPECT_LT(watch.peak(), std::size_t{4} << 20);
  }
}

// Ignored pairs are skipped where they are found, too.
TEST(BroadPhaseFilter, OfIgnoredPairsInOnePlaceTakesMemoryForThesePairsAlone) {
  constexpr std::uint32_t kBoxes = 600;
  std::vector<BoxPair> ignored;
  for (std::uint32_t a = 0; a < kBoxes; ++a) {
    for (std::uint32_t b = a + 1; b < kBoxes; ++b) {
      ignored.emplace_back(b, a);
    }
  }
  const std::vector<Box> boxes(kBoxes, Box{{3, 3, 3}, {4, 4, 4}});
  BroadPhase phase;
  EXPECT_EQ(pairs_of(phase, boxes).size(), ignored.size());
  const std::size_t all = phase.memory();
  phase.set_filter({}, ignored);
  EXPECT_TRUE(pairs_of(phase, boxes).empty());
  EXPECT_LT(phase.memory(), std::size_t{512} * kBoxes + 5 * ignored.size());
  phase.set_filter({}, {});
  EXPECT_EQ(pairs_of(phase, boxes).size(), ignored.size());
  EXPECT_LE(phase.memory(), all + 1024);
}

TEST(BroadPhaseFilter, RefusesBoxesThatCannotBe) {
  BroadPhase phase;
  const std::vector<BoxPair> ignored{{3, 1U << 27}};
  try {
    phase.set_filter({}, ignored);
    FAIL() << "the pair was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::out_of_range);
  }
}

// Boxes in one place that move apart at once, one by one, or are removed: what their pairs needed
// is given back.
TEST(BroadPhase, GivesMemoryBackWhenBoxesMoveApart) {
  constexpr std::uint32_t kBoxes = 600;
  const Box place{{3, 3, 3}, {4, 4, 4}};
  const auto away = [&](std::uint32_t k) { return moved(place, {3.0 * k + 10, 0, 0}); };
  for (const std::uint32_t at_a_time : {kBoxes, 100U, 3U}) {
    std::vector<Box> boxes(kBoxes, place);
    BroadPhase phase;
    EXPECT_EQ(phase.find(boxes).size(), kBoxes * (kBoxes - 1) / 2);
    EXPECT_GT(phase.memory(), std::size_t{3} << 20);
    for (std::uint32_t k = 0; k < kBoxes; ++k) {
      boxes[k] = away(k);
      if ((k + 1) % at_a_time == 0) {
        static_cast<void>(phase.find(boxes));
      }
    }
    EXPECT_TRUE(phase.find(boxes).empty());
    EXPECT_LT(phase.memory(), 1024 * kBoxes) << at_a_time << " at a time";
  }
  std::vector<Box> boxes(kBoxes, place);
  BroadPhase phase;
  static_cast<void>(phase.find(boxes));
  boxes.resize(10);
  EXPECT_EQ(phase.find(boxes).size(), 45U);
  EXPECT_LT(phase.memory(), std::size_t{1} << 17);
}

}  // namespace

}  // namespace soms
