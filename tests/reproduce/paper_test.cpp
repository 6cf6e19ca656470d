// The page for paper, and the command line that prints it.
#include "thesis/page/paper.h"

#include "tests/reproduce/well_formed.h"
#include "thesis/page/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace soms::reproduce {
namespace {

const std::vector<std::string_view> kVoidElements{"meta", "link", "br"};

constexpr Experiment kItem{"table-5.3", "Leaves with one triangle", Chapter::thesis, {}, 1, {}};

/// A table of `columns` columns of counts, the first two the same in every row.
Table table_with_rows(std::size_t columns, std::size_t rows) {
  Table table{.id = "wide", .caption = "Many numbers"};
  for (std::size_t k = 0; k < columns; ++k) {
    table.columns.push_back({"a_count_of_something_" + std::to_string(k)});
  }
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<Cell>& cells = table.rows.emplace_back();
    for (std::size_t k = 0; k < columns; ++k) {
      cells.emplace_back(static_cast<std::int64_t>(k < 2 ? 7 : 1000 * row + k));
    }
  }
  return table;
}

Report report_of(Table table) {
  Report report{.machine = {"Processor", "Linux", "g++ 12", "0.1.0", 2},
                .date = "2026-01-01T00:00:00Z"};
  Result result;
  result.tables = {std::move(table)};
  result.figures = {{.id = "figure_a", .caption = "A figure", .svg = "<svg></svg>"}};
  report.entries = {{&kItem, result, 1}};
  return report;
}

bool none(const std::vector<bool>& marks) {
  return std::none_of(marks.begin(), marks.end(), [](bool mark) { return mark; });
}

TEST(Paper, PageIsWellFormedAndOpenAndHasNoScript) {
  const std::string html = page(report_of(table_with_rows(3, 1000)), PageFiles::paper);
  EXPECT_EQ(test::markup_fault(html, kVoidElements), "");
  EXPECT_EQ(test::count_of(html, "<script"), 0U);
  EXPECT_GE(test::count_of(html, "<details"), 1U);
  EXPECT_EQ(test::count_of(html, "<details"), test::count_of(html, "<details open=\"\""));
  EXPECT_EQ(test::count_of(html, "@page"), 2U);
  EXPECT_GE(test::count_of(html, "soms 0.1.0, full run of 2026-01-01<"), 1U);
}

TEST(Paper, LinksToFilesAreTheirNamesAndLinksWithinThePageStay) {
  const std::string html = page(report_of(table_with_rows(3, 4)), PageFiles::paper);
  for (const char* const name : {"tables/wide.csv", "figures/figure_a.svg", "run.json"}) {
    EXPECT_GE(test::count_of(html, "<code>" + std::string(name) + "</code>"), 1U) << name;
    EXPECT_EQ(test::count_of(html, "href=\"" + std::string(name)), 0U) << name;
  }
  EXPECT_GE(test::count_of(html, "<a href=\"#item-table-5.3\">"), 1U);
}

TEST(Paper, OpensWhatIsFoldedOnceAndKeepsTheRest) {
  EXPECT_EQ(opened_for_paper("<details><summary>x</summary></details>"),
            "<details open=\"\"><summary>x</summary></details>");
  EXPECT_EQ(opened_for_paper("<details class=\"item\" open=\"\">y</details>"),
            "<details class=\"item\" open=\"\">y</details>");
  EXPECT_EQ(opened_for_paper("a <a href=\"#b\">b</a> <a href=\"c.csv\">CSV</a>, d"),
            "a <a href=\"#b\">b</a> <code>c.csv</code>, d");
  EXPECT_EQ(opened_for_paper("<a href=\"data:text/csv,1\" download=\"x\">CSV</a>."), ".");
  EXPECT_EQ(opened_for_paper("<article>a < b</article>"), "<article>a < b</article>");
  EXPECT_EQ(opened_for_paper(""), "");
}

TEST(Paper, LongTablesAreCutAndSayHowManyRowsTheFileHas) {
  EXPECT_EQ(rows_on_paper(table_with_rows(3, 64)), 64U);
  EXPECT_EQ(rows_on_paper(table_with_rows(3, 65)), 16U);
  Table of_frames = table_with_rows(3, 65);
  of_frames.columns[1].name = "frame";
  EXPECT_EQ(rows_on_paper(of_frames), 6U);
  const std::string html = page(report_of(table_with_rows(3, 1000)), PageFiles::paper);
  EXPECT_EQ(test::count_of(html,
                           "The first 16 of 1,000 rows; all of them are in "
                           "<code>tables/wide.csv</code>"),
            1U);
}

TEST(Paper, WideTablesGetSmallerTypeThenFewerColumnsThenTurnedTitles) {
  const TableFit narrow = fit_on_paper(table_with_rows(4, 3), 3);
  EXPECT_EQ(narrow.type_size, 8);
  EXPECT_TRUE(none(narrow.left_out));
  EXPECT_TRUE(none(narrow.turned));
  double before = narrow.type_size;
  bool turned = false;
  for (std::size_t columns = 5; columns < 40; ++columns) {
    const TableFit fit = fit_on_paper(table_with_rows(columns, 3), 3);
    ASSERT_EQ(fit.left_out.size(), columns);
    ASSERT_EQ(fit.turned.size(), columns);
    EXPECT_EQ(fit.left_out[0], fit.left_out[1]);
    EXPECT_FALSE(fit.left_out[2]) << "differs from row to row";
    if (!none(fit.turned)) {
      EXPECT_TRUE(fit.left_out[0]) << "titles are turned last";
    }
    EXPECT_GE(fit.type_size, 4);
    EXPECT_TRUE(fit.type_size <= before || !none(fit.turned) || fit.left_out[0]);
    before = fit.type_size;
    turned = turned || !none(fit.turned);
  }
  EXPECT_TRUE(turned);
}

TEST(Paper, ColumnsThatAreLeftOutAreSaidWithTheirValue) {
  const Table wide = table_with_rows(20, 3);
  ASSERT_TRUE(fit_on_paper(wide, 3).left_out[0]);
  const std::string html = page(report_of(wide), PageFiles::paper);
  EXPECT_EQ(
      test::count_of(html, "In all rows a count of something 0: 7, a count of something 1: 7."),
      1U);
  EXPECT_EQ(test::count_of(page(report_of(wide)), "In all rows"), 0U);
}

TEST(Paper, ChromiumReadsNothingButThePage) {
  PrintJob job{.page = "/tmp/a b/page.html", .pdf = "/tmp/a b/page.pdf", .profile = "/tmp/a b/p"};
  const std::vector<std::string> words = chromium_words(job);
  const auto has = [](const std::vector<std::string>& all, std::string_view word) {
    return std::count(all.begin(), all.end(), word) == 1;
  };
  for (const char* const word :
       {"--headless", "--no-pdf-header-footer", "--print-to-pdf=/tmp/a b/page.pdf",
        "--user-data-dir=/tmp/a b/p", "--host-resolver-rules=MAP * ~NOTFOUND"}) {
    EXPECT_TRUE(has(words, word)) << word;
  }
  EXPECT_EQ(words.back(), "file:///tmp/a%20b/page.html");
  EXPECT_FALSE(has(words, "--no-sandbox"));
  job.as_root = true;
  EXPECT_TRUE(has(chromium_words(job), "--no-sandbox"));
  EXPECT_EQ(chromium_words(job).back(), words.back());
}

}  // namespace
}  // namespace soms::reproduce
