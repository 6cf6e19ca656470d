#include "soms/scene/broad_phase.h"

#include "soms/scene/reference/broad_phase.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace soms {

namespace {

using Pairs = std::vector<BoxPair>;

Pairs ask(BroadPhase& phase, const std::vector<Box>& boxes) {
  const auto pairs = phase.find(boxes);
  return {pairs.begin(), pairs.end()};
}

Vec3 random_step(Rng& rng, double most) {
  return {rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
}

Box shifted(const Box& box, const Vec3& by) {
  return box.empty() ? box : Box{box.lower + by, box.upper + by};
}

/// Boxes of side 1 scattered over a square or a cube of `side` at `at`.
std::vector<Box> scattered(Rng& rng, std::size_t count, double side, const Vec3& at = {}) {
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 lower = at + Vec3{rng.uniform(0, side), rng.uniform(0, side), rng.uniform(0, side)};
    boxes.push_back({lower, lower + Vec3{1, 1, 1}});
  }
  return boxes;
}

TEST(BroadPhase, OfNoneOrOneBoxFindsNothing) {
  BroadPhase phase;
  EXPECT_TRUE(ask(phase, {}).empty());
  EXPECT_TRUE(ask(phase, {Box{{0, 0, 0}, {1, 1, 1}}}).empty());
  EXPECT_TRUE(ask(phase, {Box{}, Box{}}).empty());
  EXPECT_TRUE(ask(phase, {Box{{-9, -9, -9}, {9, 9, 9}}, Box{}, Box{}}).empty());
}

TEST(BroadPhase, CountsTouchingAsMeeting) {
  BroadPhase phase;
  const std::vector<Box> boxes{Box{{0, 0, 0}, {1, 1, 1}}, Box{{1, 1, 1}, {2, 2, 2}},
                               Box{{2.5, 0, 0}, {3, 1, 1}}};
  EXPECT_EQ(ask(phase, boxes), (Pairs{{0, 1}}));
}

TEST(BroadPhase, FindsWhatAScanFinds) {
  BroadPhase phase;  // reused: what an earlier call left must not show
  test::for_each_case("scene/broad-phase", 400, [&](Rng& rng) {
    const std::vector<Box> boxes = test::random_boxes(rng);
    ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes));
  });
}

// All pairs of few boxes are compared; more are swept. Floats do not show all gaps.
TEST(BroadPhase, OfFewBoxesFindsWhatAScanFindsFrameByFrame) {
  test::for_each_case("scene/broad-phase/few", 200, [](Rng& rng) {
    BroadPhase phase;
    for (int frame = 0; frame < 12; ++frame) {
      const double scale = std::pow(10.0, static_cast<double>(rng.below(5)) * 8 - 16);
      std::vector<Box> boxes = scattered(rng, rng.below(30), 3);
      for (Box& box : boxes) {
        const double gap = rng.below(2) == 0 ? 0 : 1e-12;
        const auto whole = [](double v) { return std::floor(v); };
        const Vec3 lower{whole(box.lower.x), whole(box.lower.y), whole(box.lower.z)};
        box = rng.below(20) == 0 ? Box{}
                                 : Box{lower * scale, (lower + Vec3{1 - gap, 1 - gap, 1}) * scale};
      }
      const std::vector<std::uint32_t> groups(frame % 2 == 0 ? 0 : boxes.size() / 3, 1);
      phase.set_filter(groups, {});
      ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes, groups)) << "frame " << frame;
    }
  });
}

// Straight on, at random, not at all, now and then far away; some come and go.
TEST(BroadPhase, FindsWhatAScanFindsFrameByFrame) {
  test::for_each_case("scene/broad-phase/frames", 60, [](Rng& rng) {
    std::vector<Box> boxes = test::random_boxes(rng);
    std::vector<Vec3> steps;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      steps.push_back(rng.below(4) == 0 ? Vec3{} : random_step(rng, 0.3));
    }
    const double jitter = rng.below(2) == 0 ? 0 : rng.uniform(0, 0.2);
    const std::uint64_t strays = rng.below(3);
    BroadPhase kept;
    BroadPhase rebuilt;
    for (int frame = 0; frame < 40; ++frame) {
      rebuilt.forget();
      const Pairs expected = reference::meeting_pairs(boxes);
      ASSERT_EQ(ask(kept, boxes), expected) << "frame " << frame;
      ASSERT_EQ(ask(rebuilt, boxes), expected) << "frame " << frame;
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        boxes[k] = shifted(boxes[k], steps[k] + random_step(rng, jitter));
      }
      for (std::uint64_t k = 0; k < strays && !boxes.empty(); ++k) {
        Box& box = boxes[rng.below(boxes.size())];
        if (box.empty()) {
          box = {{5, 5, 5}, {7, 7, 7}};
        } else {
          box = rng.below(3) == 0 ? Box{} : shifted(box, random_step(rng, 20));
        }
      }
      if (!boxes.empty() && rng.below(20) == 0) {
        boxes.pop_back();
      }
    }
  });
}

// Ends that coincide, in rest and in motion by whole numbers: floats leave such pairs open.
TEST(BroadPhase, OfBoxesSideBySideFindsWhatAScanFindsFrameByFrame) {
  test::for_each_case("scene/broad-phase/side-by-side", 30, [](Rng& rng) {
    const auto whole = [&](std::uint64_t below) { return static_cast<double>(rng.below(below)); };
    // Wide enough that floats cannot tell neighboring ends apart, or not.
    const double at = rng.below(2) == 0 ? 0 : 0x1p40;
    std::vector<Box> boxes;
    std::vector<Vec3> steps;
    for (int k = 0; k < 400; ++k) {
      const Vec3 lower{whole(20), whole(20), whole(20)};
      boxes.push_back({lower, lower + Vec3{whole(3), whole(3), whole(3)}});
      steps.push_back(Vec3{whole(3) - 1, whole(3) - 1, 0} * 0.25);
    }
    boxes[0] = {{at, at, at}, {at + 1, at + 1, at + 1}};
    boxes[7] = Box{};
    boxes[9] = {{-at, -at, -at}, {at, at, at}};
    BroadPhase phase;
    for (int frame = 0; frame < 30; ++frame) {
      ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes)) << "frame " << frame;
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        boxes[k] = shifted(boxes[k], steps[k]);
      }
    }
  });
}

// They stay inside the boxes that they were when all was rebuilt, whose pairs are more.
TEST(BroadPhase, OfBoxesThatShrinkFindsWhatAScanFindsFrameByFrame) {
  Rng rng(23);
  std::vector<Box> boxes = scattered(rng, 300, 8);
  BroadPhase phase;
  for (int frame = 0; frame < 20; ++frame) {
    ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes)) << "frame " << frame;
    for (Box& box : boxes) {
      box = {box.lower + Vec3{0.02, 0.02, 0.02}, box.upper - Vec3{0.02, 0.02, 0.02}};
    }
  }
}

// Some touch and some do not, which floats do not show.
TEST(BroadPhase, OfNarrowGapsFindsWhatAScanFindsFrameByFrame) {
  std::vector<Box> boxes;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      const double side = (x + y) % 3 == 0 ? 1 : 1 - 1e-12;
      boxes.push_back({{1.0 * x, 1.0 * y, 0}, {x + side, y + side, 1}});
    }
  }
  BroadPhase phase;
  for (int frame = 0; frame < 12; ++frame) {
    const Pairs expected = reference::meeting_pairs(boxes);
    ASSERT_GT(expected.size(), 100U);
    ASSERT_LT(expected.size(), 400U);  // of 506
    ASSERT_EQ(ask(phase, boxes), expected) << "frame " << frame;
    for (Box& box : boxes) {
      box = shifted(box, {0.25, 0, 0});
    }
  }
}

// Ways, sides and places that grow without end: those of the first calls say nothing of the last.
TEST(BroadPhase, OfNumbersThatGrowFindsWhatAScanFindsFrameByFrame) {
  Rng rng(17);
  std::vector<Box> boxes = scattered(rng, 200, 8);
  BroadPhase phase;
  for (int frame = 0; frame < 240; ++frame) {
    ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes)) << "frame " << frame;
    const double factor = frame < 120 ? 4 : 1 / 4.5;
    for (Box& box : boxes) {
      box = {box.lower * factor + Vec3{0, 1, 0}, box.upper * factor + Vec3{0.5, 1, 0}};
    }
  }
}

// Boxes that hardly move, of which some are added and removed, and a set that turns back.
TEST(BroadPhase, OfManyFramesOfMotionFindsWhatAScanFinds) {
  test::for_each_case("scene/broad-phase/motion", 8, [](Rng& rng) {
    std::vector<Box> boxes = scattered(rng, 300, 14);
    std::vector<Vec3> steps(400);
    const double speed = std::pow(10.0, rng.uniform(-9, 0));
    for (Vec3& step : steps) {
      step = random_step(rng, rng.below(3) == 0 ? speed / 1000 : speed);
    }
    BroadPhase phase;
    for (int frame = 0; frame < 200; ++frame) {
      ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes)) << "frame " << frame;
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        boxes[k] = shifted(boxes[k], frame % 50 == 49 ? steps[k] * -49.0 : steps[k]);
      }
      if (rng.below(40) == 0 && boxes.size() < steps.size()) {
        boxes.push_back({{1, 1, 1}, {3, 3, 3}});
      } else if (rng.below(40) == 0) {
        boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(rng.below(boxes.size())));
      }
    }
  });
}

TEST(BroadPhase, OfSlabsAmongManySmallBoxesFindsWhatAScanFinds) {
  Rng rng(7);
  std::vector<Box> boxes;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 at{rng.uniform(0, 1000), rng.uniform(0, 1000), 0};
    boxes.push_back({at, at + Vec3{2, 2, 2}});
  }
  boxes.push_back({{-5000, -5000, -1}, {5000, 5000, 0}});
  boxes.push_back({{500, -5000, -1}, {501, 5000, 1}});
  boxes.push_back({{-5000, 500, -1}, {5000, 501, 1}});
  BroadPhase phase;
  EXPECT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes));
}

TEST(BroadPhase, OfCoordinatesAtTheLimitFindsWhatAScanFinds) {
  const double far = 0x1p300;
  const std::vector<Box> boxes{Box{{-far, -far, -far}, {far, far, far}},
                               Box{{0, 0, 0}, {0x1p-1074, 0, 0}}, Box{{0, 0, 0}, {0, 0, 0}},
                               Box{{far, far, far}, {far, far, far}}, Box{}};
  BroadPhase phase;
  EXPECT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes));
  const std::vector<Box> tiny{Box{{0, 0, 0}, {0x1p-1074, 0, 0}},
                              Box{{0x1p-1074, 0, 0}, {0x1p-1073, 0, 0}},
                              Box{{0x1p-1072, 0, 0}, {0x1p-1072, 0, 0}}};
  EXPECT_EQ(ask(phase, tiny), reference::meeting_pairs(tiny));
}

// As a float its way is endless, and no call is known for which to enlarge it.
TEST(BroadPhase, FindsABoxThatJumpsBeyondTheRangeOfFloats) {
  for (const double far : {1e30, 1e60, -0x1p299}) {
    std::vector<Box> boxes;
    for (int k = 0; k < 45; ++k) {
      boxes.push_back({{2.0 * k, 0, 0}, {2.0 * k + 1, 1, 1}});
    }
    boxes.push_back({{far, 0, 0}, {far, 1, 1}});
    BroadPhase phase;
    ask(phase, boxes);
    boxes[0] = boxes[45];
    for (int frame = 0; frame < 3; ++frame) {
      EXPECT_EQ(ask(phase, boxes), (Pairs{{0, 45}})) << far << " frame " << frame;
    }
  }
}

// Whatever allocation of whichever frame fails, later frames are as if nothing had been kept.
TEST(BroadPhase, IsRightAfterMemoryRanShort) {
  for (const int faulty : {0, 1, 2, 5}) {
    for (std::uint64_t lasting = 0, failed = 1; failed != 0; ++lasting) {
      failed = 0;
      Rng rng(7);
      BroadPhase phase;
      std::size_t count = 60;
      for (int frame = 0; frame < 8; ++frame) {
        std::vector<Box> boxes = scattered(rng, count, 6);
        if (frame == faulty) {
          const test::AllocationFault fault(lasting);
          try {
            static_cast<void>(phase.find(boxes));
          } catch (const std::bad_alloc&) {
            failed = 1;
          }
        }
        ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes))
            << "frame " << frame << ", " << lasting << " allocations of frame " << faulty;
        count += frame % 2 == 0 ? 0U : 40U;
      }
    }
  }
}

TEST(BroadPhase, FarFromTheOriginFindsWhatAScanFinds) {
  for (const double far : {1e6, 1e8, 1e15}) {
    Rng rng(3);
    const std::vector<Box> boxes = scattered(rng, 600, 12, {far, -far, far});
    BroadPhase phase;
    const Pairs expected = reference::meeting_pairs(boxes);
    EXPECT_GT(expected.size(), 100U);
    EXPECT_EQ(ask(phase, boxes), expected) << far;
  }
}

TEST(BroadPhase, OfSizesOverTwelveDecadesFindsWhatAScanFinds) {
  test::for_each_case("scene/broad-phase/decades", 20, [](Rng& rng) {
    std::vector<Box> boxes;
    for (int k = 0; k < 400; ++k) {
      const double size = std::pow(10.0, rng.uniform(-6, 6));
      const Vec3 at = random_step(rng, rng.below(2) == 0 ? 1 : 1e6);
      boxes.push_back({at, at + Vec3{size, size, size}});
    }
    BroadPhase phase;
    ASSERT_EQ(ask(phase, boxes), reference::meeting_pairs(boxes));
  });
}

// Neither may make the grid useless for all others: a scan would take 1.25e9 comparisons a call.
TEST(BroadPhase, OfManyBoxesIsQuickDespiteStraysAndClusters) {
  Rng rng(11);
  std::vector<Box> boxes = scattered(rng, 25000, 300);
  BroadPhase alone;
  const std::size_t pairs = ask(alone, boxes).size();
  EXPECT_GT(pairs, 10U);
  std::vector<Box> with_strays = boxes;
  for (int k = 0; k < 5; ++k) {
    const double far = std::pow(10.0, 3 * k + 5);
    with_strays.push_back({{far, far, -far}, {far + 1, far + 1, 1 - far}});
  }
  BroadPhase phase;
  EXPECT_EQ(ask(phase, with_strays).size(), pairs);
  // A second cluster, so far from the first that floats cannot tell its boxes apart.
  std::vector<Box> clusters = boxes;
  for (const Box& box : boxes) {
    clusters.push_back(shifted(box, {0x1p34, 0x1p34, 0x1p34}));
  }
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_GE(ask(phase, clusters).size(), 2 * pairs);
    EXPECT_EQ(ask(phase, boxes).size(), pairs);
  }
}

TEST(BroadPhase, OfEqualBoxesFindsAllPairs) {
  const std::vector<Box> boxes(1500, Box{{3, 3, 3}, {4, 4, 4}});
  BroadPhase phase;
  for (int frame = 0; frame < 2; ++frame) {
    const Pairs pairs = ask(phase, boxes);
    EXPECT_EQ(pairs.size(), 1500U * 1499 / 2);
    EXPECT_EQ(pairs, reference::meeting_pairs(boxes));
  }
}

TEST(BroadPhase, IsMovedWithAllItKeeps) {
  BroadPhase phase;
  const std::vector<Box> boxes(3, Box{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(ask(phase, boxes).size(), 3U);
  const std::size_t memory = phase.memory();
  BroadPhase other = std::move(phase);
  EXPECT_EQ(other.memory(), memory);
  EXPECT_EQ(ask(other, boxes).size(), 3U);
}

}  // namespace

}  // namespace soms
