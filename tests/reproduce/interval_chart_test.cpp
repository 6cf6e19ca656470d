#include "apps/draw/interval_chart.h"

#include "soms/base/error.h"

#include "tests/reproduce/well_formed.h"

#include <gtest/gtest.h>

#include <limits>

namespace soms::reproduce {
namespace {

IntervalChart two_groups() {
  return {.title = "E-Node <against> others",
          .x_label = "ratio & interval",
          .below = 1,
          .marks = {{"orientation", "right", "stack", 1.05, Interval{1.03, 1.08}},
                    {"orientation", "right", "recursion", 0.84, Interval{0.8, 0.9}},
                    {"drives", "u_mixed", "stack", 1.1},
                    {"orientation", "left", "stack", 1.02, Interval{0.99, 1.04}}}};
}

void expect_refused(const IntervalChart& chart) {
  try {
    static_cast<void>(draw(chart));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
  }
}

TEST(IntervalChart, ShowsTitleGroupsLabelsAndSeries) {
  const std::string svg = draw(two_groups());
  EXPECT_EQ(test::markup_fault(svg), "");
  for (const char* words : {">E-Node &lt;against&gt; others<", ">ratio &amp; interval<",
                            ">orientation<", ">drives<", ">right<", ">stack<", ">recursion<"}) {
    EXPECT_GE(test::count_of(svg, words), 1U) << words;
  }
}

TEST(IntervalChart, RowsStandByGroupInOrderOfFirstAppearance) {
  const std::string svg = draw(two_groups());
  EXPECT_LT(svg.find(">right<"), svg.find(">left<"));
  EXPECT_LT(svg.find(">left<"), svg.find(">drives<"));
  EXPECT_LT(svg.find(">drives<"), svg.find(">u_mixed<"));
}

TEST(IntervalChart, MeasuredNumbersHaveWhiskersAndCountsHaveNone) {
  const std::string svg = draw(two_groups());
  EXPECT_EQ(test::count_of(svg, "stroke-width=\"1.6\""), 3U);
}

TEST(IntervalChart, ShadesWhatIsDemandedAndDrawsItsFiniteEnds) {
  IntervalChart chart = two_groups();
  EXPECT_EQ(test::count_of(draw(chart), "stroke-dasharray"), 1U);
  EXPECT_EQ(test::count_of(draw(chart), "fill-opacity"), 1U);
  chart.above = 0.9;
  EXPECT_EQ(test::count_of(draw(chart), "stroke-dasharray"), 2U);
  chart.above = -std::numeric_limits<double>::infinity();
  chart.below = std::numeric_limits<double>::infinity();
  EXPECT_EQ(test::count_of(draw(chart), "stroke-dasharray"), 0U);
  EXPECT_EQ(test::count_of(draw(chart), "fill-opacity"), 0U);
}

TEST(IntervalChart, OneSeriesHasItsValuesBeside) {
  IntervalChart chart{.title = "values", .marks = {{"", "a", "", 0.25}, {"", "b", "", 4}}};
  const std::string svg = draw(chart);
  EXPECT_EQ(test::count_of(svg, ">0.25<"), 1U);
  chart.marks[1].series = "another";
  EXPECT_EQ(test::count_of(draw(chart), ">0.25<"), 0U);
}

TEST(IntervalChart, GivesTheSameBytesForTheSameDataAndTakesNoDataAtAll) {
  EXPECT_EQ(draw(two_groups()), draw(two_groups()));
  EXPECT_EQ(test::markup_fault(draw(IntervalChart{.title = "nothing"})), "");
}

TEST(IntervalChart, ValuesThatAreMissingHaveNoDot) {
  IntervalChart chart = two_groups();
  chart.marks[1].value = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = draw(chart);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(test::count_of(svg, "stroke-width=\"1.6\""), 2U);
}

TEST(IntervalChart, ValuesBeyondTheAxisAreArrowsWithTheirNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  IntervalChart chart{.title = "far", .most = 150};
  chart.marks = {{"", "a", "one", 20},
                 {"", "b", "one", 557.292},
                 {"", "c", "two", kInfinity},
                 {"", "d", "two", -kInfinity}};
  const std::string svg = draw(chart);
  EXPECT_EQ(test::markup_fault(svg), "");
  // Each text twice: the rim of the paper's color, then the letters.
  EXPECT_EQ(test::count_of(svg, ">557<"), 2U);
  EXPECT_EQ(test::count_of(svg, ">\u221e<"), 2U);
  EXPECT_EQ(test::count_of(svg, ">-\u221e<"), 2U);
  EXPECT_EQ(test::count_of(svg, ">500<"), 0U) << "the axis reaches no further than it must";
  chart.marks.resize(1);
  chart.marks[0].series = "";
  chart.marks[0].value = kInfinity;
  EXPECT_EQ(test::count_of(draw(chart), ">\u221e<"), 2U) << "one series: not beside it again";
}

TEST(IntervalChart, RefusesWhatItCannotDraw) {
  IntervalChart chart = two_groups();
  chart.marks[0].interval->high = std::numeric_limits<double>::infinity();
  expect_refused(chart);
  chart = two_groups();
  chart.scale = Scale::log;
  EXPECT_NO_THROW(static_cast<void>(draw(chart)));
  chart.marks[2].value = 0;
  expect_refused(chart);
  chart = two_groups();
  chart.scale = Scale::log;
  chart.above = 0;
  expect_refused(chart);
}

}  // namespace
}  // namespace soms::reproduce
