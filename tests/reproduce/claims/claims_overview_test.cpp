#include "thesis/claims/claims_overview.h"

#include "tests/reproduce/well_formed.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace soms::reproduce {
namespace {

constexpr Experiment kClaimMore{"claim-more", "More", Chapter::claims, {}, 1, {}};

ClaimRow row(const char* reading, const char* subject, double value) {
  return counted_row(reading, "lead", subject, "", {.above = 0}, value);
}

Report report_of(std::vector<ClaimRow> rows, std::string nearest = {}) {
  Result result;
  result.claims = {{.id = "more",
                    .statement = "More <leaves>",
                    .source = "abstract",
                    .rows = std::move(rows),
                    .nearest = std::move(nearest)}};
  Report report;
  report.entries = {{&kClaimMore, result, 1}};
  return report;
}

std::size_t cells(const std::string& html, const char* classes) {
  // Once for wide screens, and once for narrow ones.
  const std::size_t all = test::count_of(html, fmt::format("<a class=\"cell {}\"", classes));
  EXPECT_EQ(all % 2, 0U);
  return all / 2;
}

TEST(ClaimsOverview, ALineOfTheMatrixIsACellOfItsColor) {
  ClaimRow unjudged = row("shown", "bunny", 1);
  unjudged.unjudged = "another model";
  ClaimRow open = row("open", "bunny", 1);
  open.interval = Interval{-1, 2};
  const std::string html = claims_overview(
      report_of({row("whole", "bunny", 1), row("whole", "venus", 2), row("part", "bunny", 1),
                 row("part", "venus", -1), row("none", "bunny", -1), row("none", "venus", 0), open,
                 unjudged}));
  EXPECT_EQ(cells(html, "holds"), 1U);
  EXPECT_EQ(cells(html, "holds_on_some"), 1U);
  EXPECT_EQ(cells(html, "does_not_hold"), 1U);
  EXPECT_EQ(cells(html, "undecided"), 1U);
  EXPECT_EQ(cells(html, "cannot_be_checked"), 1U);
  EXPECT_EQ(test::count_of(html, "<title>part: lead (&gt; 0): 1 of 2 rows hold</title>"), 2U)
      << html;
  EXPECT_EQ(test::markup_fault("<div>" + html + "</div>", {"br"}), "");
}

TEST(ClaimsOverview, TheNearestReadingComesFirstInAFrame) {
  const std::string html =
      claims_overview(report_of({row("far", "bunny", -1), row("near", "bunny", 1)}, "near"));
  EXPECT_EQ(cells(html, "holds nearest"), 1U);
  EXPECT_LT(html.find("<title>near"), html.find("<title>far"));
}

TEST(ClaimsOverview, IsEmptyWhereNoClaimWasTested) {
  EXPECT_EQ(claims_overview({}), "");
}

}  // namespace
}  // namespace soms::reproduce
