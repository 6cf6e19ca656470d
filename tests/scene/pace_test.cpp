#include "soms/scene/detail/pace.h"

#include "tests/support/support.h"

#include <cmath>
#include <cstdint>

namespace soms {

namespace {

/// Calls that boxes are made larger for after many rounds in which all was made anew by `work` and
/// kept pairs grew by `more_pairs` for each call ahead, if boxes stay inside as expected.
std::uint32_t settled(std::uint64_t work, std::uint64_t more_pairs) {
  detail::Pace pace;
  pace.start(work, 0);
  pace.pass();
  std::uint32_t calls = 0;
  for (int round = 0; round < 60; ++round) {
    calls = pace.next(1);
    pace.start(work, more_pairs * calls);
    for (std::uint32_t call = 0; call <= calls; ++call) {
      pace.pass();
    }
  }
  return calls;
}

TEST(Pace, LooksFarAheadWherePairsAreFewAndNotWhereTheyAreMany) {
  EXPECT_GE(settled(1000, 1), 32U);
  EXPECT_LE(settled(1000, 2000), 2U);
  const std::uint32_t between = settled(1000, 100);
  EXPECT_GE(between, 3U);
  EXPECT_LE(between, 16U);
}

TEST(Pace, TrustsNoWaysOfAJump) {
  detail::Pace pace;
  pace.start(1000, 0);
  pace.pass();
  EXPECT_GT(pace.next(1), 0U);
  EXPECT_EQ(pace.next(100), 0U);
  EXPECT_GT(pace.next(1), 0U);
}

TEST(Pace, LooksLessFarWhenBoxesBecameTooLarge) {
  detail::Pace pace;
  pace.start(1000, 0);
  pace.pass();
  const std::uint32_t calls = pace.next(1);
  pace.look_less_far();
  EXPECT_LT(pace.next(1), calls);
}

}  // namespace

}  // namespace soms
