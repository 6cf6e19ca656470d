#include "soms/base/random.h"

#include <gtest/gtest.h>

#include <array>

namespace soms {
namespace {

// First outputs of SplitMix64 from seed 1234567, as its reference implementation prints them.
TEST(Random, MatchesTheReferenceSequence) {
  Rng rng(1234567);
  for (const std::uint64_t expected :
       {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
        4593380528125082431ULL, 16408922859458223821ULL}) {
    EXPECT_EQ(rng.next(), expected);
  }
}

TEST(Random, KeepsItsRanges) {
  Rng rng(1);
  std::array<int, 5> seen{};
  for (int i = 0; i < 1000; ++i) {
    const double unit = rng.unit();
    EXPECT_GE(unit, 0);
    EXPECT_LT(unit, 1);
    const double x = rng.uniform(-3, 5);
    EXPECT_GE(x, -3);
    EXPECT_LT(x, 5);
    ++seen.at(rng.below(5));
  }
  for (const int n : seen) {
    EXPECT_GT(n, 100);
  }
}

}  // namespace
}  // namespace soms
