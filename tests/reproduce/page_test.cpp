#include "apps/draw/chart.h"
#include "tests/reproduce/well_formed.h"
#include "thesis/page/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

namespace soms::reproduce {
namespace {

const std::vector<std::string_view> kVoid{"meta", "link", "br"};

constexpr Experiment kBuild{"table-5.3", "Leaves with one triangle", Chapter::thesis, {}, 1, {}};
constexpr Experiment kSpread{"spread", "Irregular <triangles>", Chapter::beyond, {}, 1, {}};
constexpr Experiment kMissing{"figure-5.10", "E-Node & others", Chapter::thesis, {}, 1, {}};

Figure figure(const std::string& id) {
  LineChart chart{.title = id, .lines = {{.name = "SOMS", .x = {1, 2}, .y = {3, 4}}}};
  return {.id = id, .caption = "Caption of " + id, .svg = draw(chart), .alt = "Alt of " + id};
}

Report small_report() {
  Report report{.machine = {"Processor <x>", "Linux", "g++ 12", "0.1.0", 2},
                .date = "2026-01-01T00:00:00Z"};
  const auto mesh = std::make_shared<const Mesh>();
  report.models.objects = {{.name = "bunny", .title = "Bunny", .file = "bunny.ply", .mesh = mesh},
                           {.name = "venus",
                            .title = "Statue",
                            .stand_in = true,
                            .trouble = "venus.ply: no such file",
                            .mesh = mesh}};
  Result first;
  first.tables = {{.id = "table_5_3",
                   .caption = "Leaves with one triangle, level 15",
                   .columns = {{"model"}, {"one_leaf", ""}, {"time", "ms", ColumnKind::timed}},
                   .rows = {{std::string("<bunny>"), std::int64_t{1904}, 0.04321}, {{}, {}, {}}}}};
  first.figures = {figure("figure_a"), figure("figure_b")};
  first.claims = {
      {.id = "more",
       .statement = "26 % more",
       .source = "abstract",
       .rows = {counted_row("next axis", "relative", "bunny", "%", {.above = 21, .below = 31}, 25),
                counted_row("stop", "relative", "bunny", "%", {.above = 21, .below = 31}, 114)},
       .scope = Scope::figure,
       .nearest = "stop",
       .why_nearest = "As it is said.",
       .why = "Only with the next axis."},
      {.id = "balanced",
       .statement = "more balanced",
       .source = "title",
       .rows = {counted_row("", "balanced level", "venus", "", {.above = 0}, -1)},
       .why = "Object median balances better.",
       .settles = "the scene",
       .revision = Revision{Verdict::holds, "it had one metric"}}};
  first.remarks = {"Remark one & only."};
  Result second;
  second.tables = {{.id = "long_table", .caption = "Many rows", .columns = {{"n"}}}};
  for (std::int64_t k = 0; k < 1000; ++k) {
    second.tables[0].rows.push_back({k});
  }
  report.entries = {{&kBuild, first, 1.5}, {&kSpread, second, 2}};
  return report;
}

TEST(Page, IsOneWellFormedDocumentThatLoadsNothing) {
  const std::string html = page(small_report());
  EXPECT_EQ(test::markup_fault(html, kVoid), "");
  EXPECT_EQ(test::count_of(html, "<script"), 0U);
  EXPECT_EQ(test::count_of(html, " src="), 0U);
  EXPECT_EQ(test::count_of(html, "@import"), 0U);
  for (const std::string& target : test::values_of(html, "href")) {
    EXPECT_EQ(target.find("//"), std::string::npos) << target;
  }
}

TEST(Page, HasEveryFigureAndTableOfTheReport) {
  const Report report = small_report();
  const std::string html = page(report);
  for (const Entry& entry : report.entries) {
    for (const Table& table : entry.result.tables) {
      EXPECT_EQ(test::count_of(html, "<table id=\"t-" + table.id + "\""), 1U);
      EXPECT_EQ(test::count_of(html, "href=\"tables/" + table.id + ".csv\""), 1U);
      EXPECT_GE(test::count_of(html, table.caption), 1U);
    }
    for (const Figure& f : entry.result.figures) {
      EXPECT_EQ(test::count_of(html, "<figure id=\"f-" + f.id + "\""), 1U);
      EXPECT_EQ(test::count_of(html, "href=\"figures/" + f.id + ".svg\""), 1U);
      EXPECT_EQ(test::count_of(html, "aria-label=\"" + f.alt + "\""), 1U);
      EXPECT_EQ(test::count_of(html, f.caption), 1U);
    }
    for (const std::string& remark : entry.result.remarks) {
      EXPECT_EQ(remark, "Remark one & only.");
      EXPECT_EQ(test::count_of(html, "Remark one &amp; only."), 1U);
    }
  }
  EXPECT_EQ(test::count_of(html, "<svg "), 4U);  // two figures, and the claims for two widths
}

TEST(Page, OpensLargeDrawingsFromTheirFilesBesideIt) {
  Report report = small_report();
  report.entries[0].result.figures[0].svg += "<!--" + std::string(100'000, 'x') + "-->";
  const std::string beside = page(report);
  EXPECT_EQ(test::count_of(beside, "<img src=\"figures/figure_a.svg\""), 1U);
  EXPECT_EQ(test::count_of(beside, " src="), 1U);
  EXPECT_LT(beside.size(), 100'000U);
  EXPECT_EQ(test::markup_fault(beside, {"meta", "link", "br", "img"}), "");
  EXPECT_EQ(test::count_of(page(report, PageFiles::inside), " src="), 0U);
  EXPECT_EQ(test::count_of(page(report, PageFiles::inside), "<svg "), 4U);
}

TEST(Page, HasEachIdOnceAndEveryInnerLinkAnEnd) {
  const std::string html = page(small_report());
  const std::vector<std::string> ids = test::values_of(html, "id");
  const std::set<std::string> different(ids.begin(), ids.end());
  EXPECT_EQ(ids.size(), different.size());
  for (const std::string& target : test::values_of(html, "href")) {
    if (target.starts_with('#')) {
      EXPECT_EQ(different.count(target.substr(1)), 1U) << target;
    }
  }
}

TEST(Page, KeepsIdsOfDrawingsApart) {
  Report report = small_report();
  for (Figure& f : report.entries[0].result.figures) {
    f.svg =
        "<?xml version=\"1.0\"?>\n<svg><path id=\"p\" d=\"M0 0\" clip-path=\"url(#c)\"/>"
        "<use href=\"#p\"/></svg>\n";
  }
  const std::string html = page(report);
  EXPECT_EQ(test::count_of(html, "<?xml"), 0U);
  EXPECT_EQ(test::count_of(html, "id=\"f-figure_a-p\""), 1U);
  EXPECT_EQ(test::count_of(html, "href=\"#f-figure_b-p\""), 1U);
  EXPECT_EQ(test::count_of(html, "url(#f-figure_b-c)"), 1U);
}

TEST(Page, PutsClaimsBesideTheirMatrixWithTheVerdictInWords) {
  const std::string html = page(small_report());
  for (const char* words :
       {"26 % more", "+25.0 %", "holds on some subjects", "does not hold in any reading",
        "&#10007; fails</span>", "0 of 1 rows hold, on 1 subject; the share is 0 to 79 %. As it is",
        "Only with the next axis.", "Object median balances better.", "What would settle it:",
        "Holds in 1 of 2 rows. On every subject: next axis (1). On none: stop."}) {
    EXPECT_GE(test::count_of(html, words), 1U) << words;
  }
  EXPECT_EQ(test::count_of(html, "2 claims"), 1U);
}

TEST(Page, BeginsWithThePictureOfAllClaims) {
  const std::string html = page(small_report());
  const std::size_t picture = html.find("<svg class=\"matrix wide\"");
  ASSERT_NE(picture, std::string::npos);
  EXPECT_LT(picture, html.find("SOMS in today's terms"));
  EXPECT_LT(picture, html.find("id=\"questions\""));
  EXPECT_GT(html.find("SOMS in today's terms</strong>"),
            html.find("<summary>What SOMS is in today's terms"));
}

TEST(Page, PutsTheNearestVerdictBeforeThatOverAllReadings) {
  const std::string html = page(small_report());
  const std::size_t anchor = html.find("id=\"claim-more\"");
  ASSERT_NE(anchor, std::string::npos);
  const std::size_t row = html.rfind("<details", anchor);
  EXPECT_LT(html.find("fails</span>", row), html.find("holds on some subjects</span>", row));
  EXPECT_GE(test::count_of(html, "Toy sets, which this project made to show a picture"), 1U);
  EXPECT_GE(test::count_of(html, "not independent draws"), 1U);
}

TEST(Page, SaysInOneParagraphWhichVerdictsChanged) {
  Report report = small_report();
  EXPECT_EQ(test::count_of(page(report), "for it had one metric."), 1U);
  report.entries[0].result.claims[1].revision->before = Verdict::does_not_hold;
  EXPECT_EQ(test::count_of(page(report), "first edition"), 0U);
}

TEST(Page, MarksStandInsAndTroubles) {
  const std::string html = page(small_report());
  EXPECT_EQ(test::count_of(html, ">stand-in<"), 1U);
  EXPECT_EQ(test::count_of(html, "venus.ply: no such file"), 1U);
}

TEST(Page, SaysWhatAnInterruptedRunLacks) {
  Report report = small_report();
  EXPECT_EQ(test::count_of(page(report), "interrupted"), 0U);
  report.missing = {&kMissing};
  const std::string html = page(report);
  EXPECT_GE(test::count_of(html, "interrupted"), 2U);
  EXPECT_EQ(test::count_of(html, ">not run<"), 1U);
  EXPECT_EQ(test::count_of(html, "id=\"item-figure-5.10\""), 1U);
  report.entries.clear();
  EXPECT_EQ(test::markup_fault(page(report), kVoid), "");
}

TEST(Page, FoldsLongTablesAndCutsVeryLongOnes) {
  const std::string html = page(small_report());
  EXPECT_EQ(test::count_of(html, "<details>\n<summary>Many rows"), 1U);
  EXPECT_EQ(test::count_of(html, "The first 40 of 1,000 rows"), 1U);
  EXPECT_EQ(test::count_of(html, ">39<"), 1U);
  EXPECT_EQ(test::count_of(html, ">40<"), 0U);
}

TEST(Page, EscapesWordsAndWritesNumbersForPeople) {
  const std::string html = page(small_report());
  EXPECT_EQ(test::count_of(html, "&lt;bunny&gt;"), 1U);
  EXPECT_EQ(test::count_of(html, "Irregular &lt;triangles&gt;"), 2U);
  EXPECT_EQ(test::count_of(html, ">1,904<"), 1U);
  EXPECT_EQ(test::count_of(html, ">0.0432<"), 1U);
  EXPECT_EQ(test::count_of(html, "one leaf"), 1U);
}

TEST(Manifest, IsWrittenWhateverBytesTheNameOfAModelHolds) {
  Report report = small_report();
  report.models.objects[0].file = "gro\xdf.3ds";
  EXPECT_EQ(test::count_of(manifest(report), R"(gro\ufffd.3ds)"), 1U);
}

TEST(Page, MarksAQuickRun) {
  Report report = small_report();
  EXPECT_EQ(test::count_of(page(report), "Quick run"), 0U);
  report.quick = true;
  EXPECT_EQ(test::count_of(page(report), "Quick run"), 1U);
}

}  // namespace
}  // namespace soms::reproduce
