#include "thesis/claims/research_questions.h"

#include "tests/reproduce/well_formed.h"

#include <gtest/gtest.h>

#include <string>

namespace soms::reproduce {
namespace {

constexpr Experiment kRight{"figure-5.6", "Orientation test right", Chapter::thesis, {}, 1, {}};
constexpr Experiment kSingles{"claim-single-leaves", "Singles", Chapter::claims, {}, 1, {}};

Table times(double soms_rate) {
  Table table{.id = "figure_5_6_times", .caption = "Times"};
  for (const char* name : {"model", "rule", "quantity", "mean"}) {
    table.columns.push_back({name});
  }
  const auto row = [&](const char* model, const char* rule, const char* quantity, double mean) {
    table.rows.push_back({std::string(model), std::string(rule), std::string(quantity), mean});
  };
  row("bunny", "spatial_median", "fps", 1);
  row("bunny", "soms", "frame (ms)", 2);
  row("bunny", "soms", "fps", 5000);
  row("venus", "soms", "fps", soms_rate);
  return table;
}

Table counts() {
  Table table{.id = "figure_5_6_counts", .caption = "Counts"};
  for (const char* name :
       {"model", "rule", "frames", "root_overlap_frames", "hit_frames", "first_contact_frame"}) {
    table.columns.push_back({name});
  }
  table.rows.push_back({std::string("bunny"), std::string("soms"), std::int64_t{49},
                        std::int64_t{17}, std::int64_t{15}, std::int64_t{36}});
  return table;
}

Report report_of(double soms_rate) {
  Report report;
  Result right;
  right.tables = {times(soms_rate), counts()};
  Result singles;
  singles.claims = {{.id = "more_single_leaves",
                     .statement = "More <singles>",
                     .source = "abstract",
                     .rows = {counted_row("stop", "lead", "bunny", "", {.above = 0}, 3)}}};
  report.entries = {{&kRight, right, 1}, {&kSingles, singles, 1}};
  return report;
}

TEST(ResearchQuestions, AllSevenAreAnsweredWithoutAnyRun) {
  const std::string html = questions_section({});
  EXPECT_EQ(test::count_of(html, "<li>"), 7U);
  EXPECT_EQ(test::markup_fault("<div>" + html + "</div>", {}), "");
  EXPECT_EQ(test::count_of(html, "href"), 0U) << "a link to what did not run";
}

TEST(ResearchQuestions, ClaimsStandAsTheirRowsSay) {
  const std::string html = questions_section(report_of(300));
  EXPECT_EQ(test::count_of(html, "href=\"#claim-more_single_leaves\">More &lt;singles&gt;</a>"),
            1U);
  EXPECT_EQ(test::count_of(html, "href=\"#item-claim-single-leaves\""), 1U);
}

TEST(ResearchQuestions, TheSlowestObjectBySomsStandsBesideTheRatesOfSection11) {
  EXPECT_EQ(test::count_of(questions_section(report_of(305)),
                           "(venus, test right) has <em>305</em> frames a second on this machine, "
                           "5 times the 60."),
            1U);
  const std::string slow = questions_section(report_of(41));
  EXPECT_EQ(test::count_of(slow, "wants 30 to 60 frames a second"), 1U);
  EXPECT_EQ(test::count_of(slow, "<em>41</em> frames a second on this machine."), 1U);
  EXPECT_EQ(test::count_of(slow, "times the 60"), 0U);
}

TEST(ResearchQuestions, AccuracySaysWhereBoxesOverlapAndTrianglesDoNot) {
  EXPECT_EQ(test::count_of(questions_section(report_of(300)),
                           "of 49 frames of bunny coming from the right the roots overlap in 17 "
                           "and leaves in 15; triangles touch from frame 36 on."),
            1U);
}

}  // namespace
}  // namespace soms::reproduce
