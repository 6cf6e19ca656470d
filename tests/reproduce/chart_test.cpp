#include "apps/draw/chart.h"

#include "soms/base/error.h"

#include "apps/draw/chart_parts.h"
#include "tests/reproduce/well_formed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace soms::reproduce {
namespace {

const double kNoValue = std::numeric_limits<double>::quiet_NaN();

LineChart two_lines() {
  LineChart chart{.title = "Nodes by <level>", .x_label = "level", .y_label = "nodes & leaves"};
  chart.lines = {{.name = "SOMS", .x = {1, 2, 3}, .y = {1, 3, 7}},
                 {.name = "spatial \"median\"",
                  .x = {1, 2, 3},
                  .y = {1, 3, 5},
                  .low = {0.5, 2, 4},
                  .high = {2, 4, 6}}};
  chart.callouts = {{3, 5, "here <it> stops"}};
  return chart;
}

void expect_refused(const LineChart& chart) {
  try {
    static_cast<void>(draw(chart));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
  }
}

TEST(LineChart, ShowsTitleLabelsNamesAndCallouts) {
  const std::string svg = draw(two_lines());
  EXPECT_EQ(test::markup_fault(svg), "");
  for (const char* words : {">Nodes by &lt;level&gt;<", ">level<", ">nodes &amp; leaves<", ">SOMS<",
                            ">spatial &quot;median&quot;<", ">here &lt;it&gt; stops<"}) {
    EXPECT_GE(test::count_of(svg, words), 1U) << words;
  }
}

TEST(LineChart, GivesTheSameBytesForTheSameData) {
  EXPECT_EQ(draw(two_lines()), draw(two_lines()));
}

TEST(LineChart, BreaksALineWhereAValueIsMissing) {
  LineChart chart = two_lines();
  chart.lines.resize(1);
  chart.callouts.clear();
  chart.markers = false;
  const std::size_t whole = test::count_of(draw(chart), "stroke-width=\"2.4\"");
  chart.lines[0].x = {1, 2, 3, 4, 5};
  chart.lines[0].y = {1, 2, kNoValue, 4, 5};
  EXPECT_EQ(test::count_of(draw(chart), "stroke-width=\"2.4\""), whole + 1);
}

TEST(LineChart, DrawsWithoutDataOrWithOnePoint) {
  LineChart chart{.title = "empty"};
  EXPECT_EQ(test::markup_fault(draw(chart)), "");
  EXPECT_EQ(test::count_of(draw(chart), "no data"), 1U);
  chart.lines = {{.name = "one", .x = {0}, .y = {0}, .low = {0}, .high = {0}}};
  EXPECT_EQ(test::markup_fault(draw(chart)), "");
  chart.lines = {{.name = "none", .x = {1, 2}, .y = {kNoValue, kNoValue}}};
  EXPECT_EQ(test::count_of(draw(chart), "no data"), 1U);
  EXPECT_EQ(test::count_of(draw(chart), "nan"), 0U);
}

TEST(LineChart, RefusesListsThatDifferAndLogsOfNothing) {
  LineChart chart = two_lines();
  chart.lines[0].y.pop_back();
  expect_refused(chart);
  chart = two_lines();
  chart.lines[1].low.pop_back();
  expect_refused(chart);
  chart = two_lines();
  chart.lines[0].y[0] = 0;
  EXPECT_NO_THROW(static_cast<void>(draw(chart)));
  chart.y_scale = Scale::log;
  expect_refused(chart);
  chart = two_lines();
  chart.lines[0].x[0] = kNoValue;
  expect_refused(chart);
}

TEST(LineChart, TellsLinesApartWithoutColor) {
  LineChart chart{.title = "many points", .markers = false};
  for (int k = 0; k < 2; ++k) {
    Line line{.name = "line " + std::to_string(k)};
    for (int i = 0; i < 200; ++i) {
      line.x.push_back(i);
      line.y.push_back(i * (k + 1));
    }
    chart.lines.push_back(line);
  }
  const std::string svg = draw(chart);
  // The marker of each line, on the line and beside its name.
  EXPECT_GE(test::count_of(svg, "m-4,0a4,4"), 4U);
  EXPECT_GE(test::count_of(svg, "m-3.6,-3.6h7.2"), 4U);
}

TEST(BarChart, ShowsGroupsNamesAndValues) {
  BarChart chart{.title = "Leaves", .y_label = "leaves with one triangle"};
  chart.groups = {"bunny", "a very long name of a model that nobody could put below a bar, teapot"};
  chart.bars = {{.name = "SOMS", .values = {904, 1234}},
                {.name = "spatial", .values = {423, kNoValue}, .low = {400, 1}, .high = {430, 2}}};
  const std::string svg = draw(chart);
  EXPECT_EQ(test::markup_fault(svg), "");
  for (const char* words : {">bunny<", ">SOMS<", ">904<", ">1,234<", ">423<"}) {
    EXPECT_GE(test::count_of(svg, words), 1U) << words;
  }
  EXPECT_EQ(test::count_of(svg, "nan"), 0U);
  EXPECT_EQ(svg, draw(chart));
}

TEST(BarChart, LaysBarsDownWhereTheyAreTooManyToStand) {
  BarChart chart{.title = "Times", .y_label = "ms", .y_scale = Scale::log};
  Bars bars{.name = "SOMS"};
  for (int k = 1; k <= 60; ++k) {
    chart.groups.push_back("model " + std::to_string(k));
    bars.values.push_back(k);
  }
  chart.bars = {bars, bars};
  const std::string svg = draw(chart);
  EXPECT_EQ(test::markup_fault(svg), "");
  for (const std::string& group : chart.groups) {
    EXPECT_EQ(test::count_of(svg, ">" + group + "<"), 1U);
  }
}

TEST(BarChart, RefusesListsThatDiffer) {
  BarChart chart{.title = "t", .groups = {"a", "b"}, .bars = {{.name = "x", .values = {1}}}};
  EXPECT_THROW(static_cast<void>(draw(chart)), Error);
  chart.bars[0].values = {1, 0};
  EXPECT_NO_THROW(static_cast<void>(draw(chart)));
  chart.y_scale = Scale::log;
  EXPECT_THROW(static_cast<void>(draw(chart)), Error);
}

TEST(ChartParts, SpreadsLabelsApartAndInside) {
  const std::vector<double> heights(4, 20);
  const std::vector<double> tops = spread({50, 52, 51, 99}, heights, 0, 100);
  EXPECT_EQ(tops[0] + 20, tops[2]);
  EXPECT_EQ(tops[2] + 20, tops[1]);
  EXPECT_EQ(tops[1] + 20, tops[3]);
  EXPECT_EQ(tops[3], 80);
}

TEST(ChartParts, FindsAPlaceThatCoversNoData) {
  const Plot plot{0, 0, 300, 200};
  Clearings clearings(plot);
  clearings.cover({0, 0}, 300, 120);
  const Spot corner = clearings.find({150, 100}, 80, 30);
  EXPECT_GE(corner.y, 120);
  EXPECT_LE(corner.y + 30, 200);
  clearings.cover(corner, 80, 30);
  const Spot next = clearings.find({150, 100}, 80, 30);
  EXPECT_TRUE(next.x >= corner.x + 80 || next.x + 80 <= corner.x || next.y >= corner.y + 30);
}

}  // namespace
}  // namespace soms::reproduce
