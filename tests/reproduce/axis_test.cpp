#include "apps/draw/axis.h"

#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

std::string labels(const AxisRange& range) {
  std::string words;
  const Axis axis(range);
  for (const Tick& tick : axis.ticks()) {
    words += (words.empty() ? "" : " ") + tick.label;
  }
  return words;
}

TEST(Axis, MarksRoundNumbersThatReachAroundTheValues) {
  EXPECT_EQ(labels({.low = 3, .high = 96, .rounded = true, .most_ticks = 6}), "0 20 40 60 80 100");
  EXPECT_EQ(labels({.low = 0.11, .high = 0.29, .rounded = true, .most_ticks = 6}),
            "0 0.05 0.1 0.15 0.2 0.25 0.3");
  EXPECT_EQ(labels({.low = -7, .high = 12, .rounded = true, .most_ticks = 6}), "-10 -5 0 5 10 15");
  EXPECT_EQ(labels({.low = 900, .high = 1000, .rounded = true, .most_ticks = 6}),
            "900 920 940 960 980 1,000");
}

TEST(Axis, KeepsWholeNumbersWhole) {
  EXPECT_EQ(labels({.low = 1, .high = 4, .whole = true, .most_ticks = 15}), "1 2 3 4");
  EXPECT_EQ(labels({.low = 7, .high = 7, .whole = true}), "7");
}

TEST(Axis, MarksPowersOfTenAndBetweenThemWhereTheyAreFew) {
  EXPECT_EQ(labels({.low = 0.002, .high = 300, .scale = Scale::log, .rounded = true}),
            "0.001 0.01 0.1 1 10 100 1,000");
  EXPECT_EQ(labels({.low = 3, .high = 40, .scale = Scale::log, .rounded = true}), "2 5 10 20 50");
  EXPECT_EQ(labels({.low = 30, .high = 31, .scale = Scale::log}), "20 50");
  EXPECT_EQ(labels({.low = 1, .high = 1e12, .scale = Scale::log, .rounded = true}),
            "1 100 10,000 1 M 100 M 10 G 1000 G");
}

TEST(Axis, PlacesEndsAtZeroAndOne) {
  const Axis axis({.low = 1, .high = 1000, .scale = Scale::log});
  EXPECT_DOUBLE_EQ(axis.share(1), 0);
  EXPECT_NEAR(axis.share(10), 1.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(axis.share(1000), 1);
  const Axis linear({.low = 2, .high = 4});
  EXPECT_DOUBLE_EQ(linear.share(3), 0.5);
}

TEST(Axis, WritesNumbersShort) {
  EXPECT_EQ(number_label(0.05), "0.05");
  EXPECT_EQ(number_label(3 * 0.1), "0.3");
  EXPECT_EQ(number_label(-12000), "-12,000");
  EXPECT_EQ(number_label(2.5e6), "2.5 M");
  EXPECT_EQ(value_label(1234567), "1,234,567");
  EXPECT_EQ(value_label(0.04321), "0.0432");
  EXPECT_EQ(value_label(12345.6), "12,346");
  EXPECT_EQ(value_label(999.4), "999");
  EXPECT_EQ(value_label(999.7), "1,000");
}

}  // namespace
}  // namespace soms::reproduce
