// Listings: code beside examples, beside steps, or above steps that are too wide.
#include "thesis/page/listing.h"

#include "tests/reproduce/well_formed.h"

#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

using soms::test::count_of;
using soms::test::markup_fault;

const std::vector<CodeLine> kLines{{0, "add (a, b):"}, {1, "if a < b & b > 0:", "no"}};

TEST(Listing, ShowsExamplesBesideTheirLines) {
  const std::string svg = draw_listing({.title = "T", .lines = kLines, .heading = "the set"});
  EXPECT_EQ(markup_fault(svg), "");
  EXPECT_EQ(count_of(svg, ">if a &lt; b &amp; b &gt; 0:<"), 1U);
  EXPECT_EQ(count_of(svg, ">no<"), 1U);
  EXPECT_EQ(count_of(svg, ">the set<"), 1U);
  EXPECT_EQ(count_of(svg, ">2<"), 1U);  // the number of the second line
}

TEST(Listing, ShowsStepsWithAllDigitsThatTheCsvHas) {
  const Table steps{.id = "t",
                    .caption = "",
                    .columns = {{"tree_id"}, {"half"}, {"note"}},
                    .rows = {{std::int64_t{12345}, 0.123456, std::string("x")},
                             {std::monostate{}, 2.0, std::string("y")}}};
  const std::string svg = draw_listing({.title = "T", .lines = kLines, .steps = &steps});
  EXPECT_EQ(markup_fault(svg), "");
  EXPECT_EQ(count_of(svg, ">tree id<"), 1U);
  EXPECT_EQ(count_of(svg, ">12,345<"), 1U);
  EXPECT_EQ(count_of(svg, ">0.123456<"), 1U);
}

/// Width and height of a page.
std::pair<double, double> size_of(const std::string& svg) {
  const std::string box = soms::test::values_of(svg, "viewBox").at(0);
  const std::size_t height = box.rfind(' ');
  const std::size_t width = box.rfind(' ', height - 1);
  return {std::stod(box.substr(width)), std::stod(box.substr(height))};
}

TEST(Listing, PutsStepsBelowTheCodeWhereTheyAreTooWide) {
  Table steps{.id = "t", .caption = "", .columns = {{"a"}}, .rows = {{std::string("short")}}};
  const auto [width, height] =
      size_of(draw_listing({.title = "T", .lines = kLines, .steps = &steps}));
  steps.rows[0][0] = std::string(150, 'w');
  const auto [wide, high] = size_of(draw_listing({.title = "T", .lines = kLines, .steps = &steps}));
  EXPECT_EQ(width, 1000);
  EXPECT_GT(wide, width);
  EXPECT_GT(high, height + 40);
}

TEST(Listing, ResultTellsTheCodeAndThatTheOriginalWasNotAvailable) {
  const Table steps{.id = "t", .caption = "", .columns = {{"a"}}, .rows = {{1.0}}};
  const Result result =
      listing_result("figure_0", "A sum.", {.title = "T", .lines = kLines}, steps);
  ASSERT_EQ(result.figures.size(), 1U);
  EXPECT_EQ(result.figures[0].caption,
            "A sum. From the caption; the thesis' own listing was not available to us.");
  EXPECT_EQ(result.figures[0].alt, "1: add (a, b): 2: if a < b & b > 0: ");
  ASSERT_EQ(result.tables.size(), 1U);
  EXPECT_EQ(result.tables[0].id, "t");
}

}  // namespace
}  // namespace soms::reproduce
