#include "soms/scene/detail/rebuild_interval.h"

#include "tests/support/support.h"

#include <cstdint>

namespace soms {

namespace {

/// Boxes that move a tenth of their side in each call.
detail::Outlook steady(double speed = 1) {
  return {speed, speed, {0.1, 0.1, 0.1}};
}

/// Calls that boxes are made larger for after many rounds in which all was rebuilt by `work`,
/// `pairs` pairs were found in each call, and boxes stay inside as expected.
std::uint32_t settled(std::uint64_t work, std::uint64_t pairs) {
  detail::RebuildInterval interval;
  interval.start(work, pairs);
  interval.pass();
  std::uint32_t calls = 0;
  for (int round = 0; round < 20; ++round) {
    interval.find(pairs);
    calls = interval.next(steady());
    const double length = 1 + 0.1 * calls;
    interval.start(
        work, static_cast<std::uint64_t>(static_cast<double>(pairs) * length * length * length));
    for (std::uint32_t call = 0; call <= calls; ++call) {
      interval.pass();
    }
  }
  return calls;
}

TEST(RebuildInterval, LooksFarAheadWherePairsAreFewAndNotWhereTheyAreMany) {
  EXPECT_EQ(settled(1000, 0), 64U);
  EXPECT_LE(settled(1000, 100000), 1U);
  const std::uint32_t between = settled(1000, 500);
  EXPECT_GE(between, 3U);
  EXPECT_LE(between, 16U);
}

TEST(RebuildInterval, MakesNoBoxesLargerThatMoveFarAmongMany) {
  detail::RebuildInterval interval;
  interval.start(1000, 5000);
  interval.find(5000);
  interval.pass();
  EXPECT_EQ(interval.next({1, 1, {2, 2, 2}}), 0U);
}

// Boxes just beside each other: few pairs meet, and many larger ones do.
TEST(RebuildInterval, LooksLessFarWhereMorePairsAreKeptThanExpected) {
  detail::RebuildInterval interval;
  interval.start(1000, 1000);
  interval.find(1000);
  interval.pass();
  const std::uint32_t first = interval.next(steady());
  EXPECT_GT(first, 1U);
  interval.start(1000, 100000);
  for (std::uint32_t call = 0; call <= first; ++call) {
    interval.pass();
  }
  EXPECT_LT(interval.next(steady()), first);
}

TEST(RebuildInterval, MakesNoBoxesLargerThatDoNotStayInside) {
  detail::RebuildInterval interval;
  interval.start(1000, 0);
  interval.pass();
  int larger = 0;
  for (int round = 0; round < 200; ++round) {
    larger += interval.next(steady()) > 0 ? 1 : 0;
    interval.start(1000, 0);
    interval.pass();
  }
  EXPECT_GT(larger, 2);  // now and then it tries
  EXPECT_LT(larger, 20);
}

TEST(RebuildInterval, TrustsNoMotionOfAJump) {
  detail::RebuildInterval interval;
  interval.start(1000, 0);
  interval.pass();
  EXPECT_GT(interval.next(steady()), 0U);
  interval.start(1000, 0);
  interval.pass();
  detail::Outlook jump = steady();
  jump.last = 100;
  EXPECT_EQ(interval.next(jump), 0U);
  interval.start(1000, 0);
  interval.pass();
  EXPECT_GT(interval.next(steady()), 0U);
}

TEST(RebuildInterval, LooksLessFarWhenBoxesBecameTooLarge) {
  detail::RebuildInterval interval;
  interval.start(1000, 0);
  interval.pass();
  const std::uint32_t calls = interval.next(steady());
  interval.look_less_far();
  interval.start(1000, 0);
  interval.pass();
  EXPECT_LT(interval.next(steady()), calls);
}

}  // namespace

}  // namespace soms
