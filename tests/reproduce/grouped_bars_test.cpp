#include "apps/draw/grouped_bars.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace soms::reproduce {
namespace {

TEST(GroupedBars, GroupsAndBarsStandInOrderOfFirstAppearance) {
  const std::array data{Datum{"b", "x", 1}, Datum{"b", "y", 2}, Datum{"a", "y", 3}};
  const BarChart chart = grouped_bars("title", "unit", data);
  EXPECT_EQ(chart.groups, (std::vector<std::string>{"b", "a"}));
  ASSERT_EQ(chart.bars.size(), 2U);
  EXPECT_EQ(chart.bars[0].name, "x");
  EXPECT_EQ(chart.bars[1].values, (std::vector<double>{2, 3}));
  EXPECT_TRUE(chart.bars[1].low.empty());
}

TEST(GroupedBars, PairThatIsMissingHasNoBar) {
  const std::array data{Datum{"b", "x", 1}, Datum{"a", "y", 3}};
  const BarChart chart = grouped_bars("", "", data);
  EXPECT_EQ(chart.bars[0].values[0], 1);
  EXPECT_TRUE(std::isnan(chart.bars[0].values[1]));
  EXPECT_TRUE(std::isnan(chart.bars[1].values[0]));
}

TEST(GroupedBars, SpreadGoesWithItsBar) {
  const std::array data{Datum{"a", "x", 2, 1, 4}, Datum{"b", "x", 5, 3, 6}};
  const BarChart chart = grouped_bars("", "", data);
  EXPECT_EQ(chart.bars[0].low, (std::vector<double>{1, 3}));
  EXPECT_EQ(chart.bars[0].high, (std::vector<double>{4, 6}));
}

TEST(GroupedBars, NoDataIsAnEmptyChart) {
  EXPECT_TRUE(grouped_bars("", "", {}).groups.empty());
}

}  // namespace
}  // namespace soms::reproduce
