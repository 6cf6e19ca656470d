#include "soms/query/detail/winding/angle_sum.h"

#include "soms/base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soms::detail {
namespace {

constexpr long double kRadiansOfTurn = 6.283185307179586476925286766559005768L;

TEST(AngleSum, KnowsArgumentsToItsError) {
  Rng rng(3);
  for (int i = 0; i < 200'000; ++i) {
    const double re = std::ldexp(rng.uniform(-1, 1), static_cast<int>(rng.below(30)) - 30);
    const double im = std::ldexp(rng.uniform(-1, 1), static_cast<int>(rng.below(30)) - 30);
    const long double truth =
        std::atan2(static_cast<long double>(im), static_cast<long double>(re)) / kRadiansOfTurn;
    ASSERT_LE(std::abs(argument_in_turns(re, im) - truth), kArgumentError);
  }
}

TEST(AngleSum, KnowsTheAxes) {
  EXPECT_EQ(argument_in_turns(1, 0.0), 0);
  EXPECT_EQ(argument_in_turns(0, 1), 0.25);
  EXPECT_EQ(argument_in_turns(0, -1), -0.25);
  EXPECT_EQ(argument_in_turns(-1, 0.0), 0.5);
  EXPECT_EQ(argument_in_turns(-1, -0.0), -0.5);
  EXPECT_EQ(argument_in_turns(2, 2), 0.125);
}

TEST(AngleSum, CountsTurns) {
  Rng rng(5);
  for (int run = 0; run < 300; ++run) {
    AngleSum sum;
    long double truth = 0;
    for (int i = 0; i < 500; ++i) {
      // Every seventh is on an axis, or all but on it.
      const double angle = rng.below(7) == 0 ? 0.25 * static_cast<double>(rng.below(4)) - 0.25
                                             : rng.uniform(-0.5, 0.5);
      const long double radian = kRadiansOfTurn * static_cast<long double>(angle);
      const double size = std::exp2(rng.uniform(-90, 1));
      double re = size * static_cast<double>(std::cos(radian));
      double im = size * static_cast<double>(std::sin(radian));
      if (angle == 0.5 || angle == 0) {
        im = std::copysign(0.0, angle);
      }
      sum.add(re, im);
      truth +=
          std::atan2(static_cast<long double>(im), static_cast<long double>(re)) / kRadiansOfTurn;
    }
    ASSERT_NEAR(static_cast<double>(sum.turns() + sum.rest() - truth), 0, 500 * 0.4 * 0x1p-53);
  }
}

TEST(AngleSum, CountsHalfTurnsByTheSignOfZero) {
  AngleSum up;
  AngleSum down;
  for (int i = 0; i < 7; ++i) {
    up.add(-1, 0.0);
    down.add(-0.5, -0.0);
    EXPECT_EQ(up.turns() + up.rest(), 0.5 * (i + 1));
    EXPECT_EQ(down.turns() + down.rest(), -0.5 * (i + 1));
  }
}

}  // namespace
}  // namespace soms::detail
