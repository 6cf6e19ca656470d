#include "soms/scene/detail/rebuild_interval.h"

#include "tests/support/support.h"

#include <cmath>
#include <cstdint>

namespace soms {

namespace {

/// Calls that boxes are made larger for after many rounds in which all was rebuilt by `work` and
/// kept pairs grew by `more_pairs` for each call ahead, if boxes stay inside as expected.
std::uint32_t settled(std::uint64_t work, std::uint64_t more_pairs) {
  detail::RebuildInterval interval;
  interval.start(work, 0);
  interval.pass();
  std::uint32_t calls = 0;
  for (int round = 0; round < 60; ++round) {
    calls = interval.next(1);
    interval.start(work, more_pairs * calls);
    for (std::uint32_t call = 0; call <= calls; ++call) {
      interval.pass();
    }
  }
  return calls;
}

TEST(RebuildInterval, LooksFarAheadWherePairsAreFewAndNotWhereTheyAreMany) {
  EXPECT_GE(settled(1000, 1), 32U);
  EXPECT_LE(settled(1000, 2000), 2U);
  const std::uint32_t between = settled(1000, 100);
  EXPECT_GE(between, 3U);
  EXPECT_LE(between, 16U);
}

TEST(RebuildInterval, TrustsNoMotionOfAJump) {
  detail::RebuildInterval interval;
  interval.start(1000, 0);
  interval.pass();
  EXPECT_GT(interval.next(1), 0U);
  EXPECT_EQ(interval.next(100), 0U);
  EXPECT_GT(interval.next(1), 0U);
}

TEST(RebuildInterval, LooksLessFarWhenBoxesBecameTooLarge) {
  detail::RebuildInterval interval;
  interval.start(1000, 0);
  interval.pass();
  const std::uint32_t calls = interval.next(1);
  interval.look_less_far();
  EXPECT_LT(interval.next(1), calls);
}

}  // namespace

}  // namespace soms
