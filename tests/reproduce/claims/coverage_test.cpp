// Which tables and figures of the thesis are shown, and where options come from.
#include "thesis/claims/coverage.h"

#include "tests/reproduce/trips.h"
#include "thesis/claims/sources.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::run_quick;
using trips::table_of;

std::vector<ThesisItem> items() {
  const std::span<const ThesisItem> all = thesis_items();
  return {all.begin(), all.end()};
}

ThesisItem& item_of(std::vector<ThesisItem>& all, std::string_view name) {
  return *std::find_if(all.begin(), all.end(),
                       [&](const ThesisItem& item) { return item_name(item) == name; });
}

std::vector<std::string> faults(std::span<const ThesisItem> all) {
  return coverage_faults(all, experiments());
}

TEST(Coverage, EveryTableAndFigureIsShownOrExplained) {
  EXPECT_EQ(faults(thesis_items()), std::vector<std::string>{});
  const std::span<const ThesisItem> all = thesis_items();
  EXPECT_EQ(static_cast<std::size_t>(std::count_if(
                all.begin(), all.end(),
                [](const ThesisItem& item) { return item.kind == ThesisItemKind::table; })),
            kThesisTables);
  EXPECT_EQ(all.size(), kThesisTables + kThesisFigures);
}

TEST(Coverage, PlantedFaultsAreFound) {
  std::vector<ThesisItem> all = items();
  item_of(all, "figure-4.30").why_not = "No reason.";
  EXPECT_EQ(faults(all), std::vector<std::string>{"figure-4.30 is both shown and explained"});

  all = items();
  item_of(all, "figure-4.38").why_not = {};
  EXPECT_EQ(faults(all), std::vector<std::string>{"figure-4.38 is neither shown nor explained"});

  all = items();
  item_of(all, "figure-2.12").elsewhere = "figure-9.9";
  EXPECT_EQ(faults(all),
            std::vector<std::string>{"figure-2.12 refers to figure-9.9, which is not an item"});

  all = items();
  all.push_back(item_of(all, "table-2.1"));
  EXPECT_EQ(faults(all), std::vector<std::string>{"table-2.1 is listed twice"});

  all = items();
  item_of(all, "table-2.1").number = "2.3";
  EXPECT_EQ(faults(all),
            (std::vector<std::string>{"table-2.1 is missing", "table-2.3 is not in the thesis"}));

  all = items();
  std::erase_if(all, [](const ThesisItem& item) { return item_name(item) == "table-5.3"; });
  EXPECT_EQ(faults(all),
            (std::vector<std::string>{"table-5.3 is missing",
                                      "table-5.3 is not among the items of the thesis"}));
}

TEST(Coverage, TableSaysWhatShowsAnItemOrWhyNothingDoes) {
  const Result result = run_quick("coverage", {});
  const Table& table = table_of(result, "coverage");
  ASSERT_EQ(table.rows.size(), kThesisTables + kThesisFigures);
  std::int64_t shown_tables = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const bool named = !cell(table, row, "item").empty();
    EXPECT_NE(named, !cell(table, row, "why_not").empty()) << row;
    EXPECT_EQ(cell(table, row, "shown") != "no", named) << row;
    shown_tables += cell(table, row, "kind") == "table" && named ? 1 : 0;
  }
  EXPECT_EQ(shown_tables, 14);
  EXPECT_EQ(result.remarks.at(0),
            "14 of 16 tables have an item of their own, 0 are shown by another item, 2 are not "
            "shown.");
  EXPECT_EQ(cell(table, 4, "number"), "3.3");
  EXPECT_EQ(cell(table, 4, "item"), "table-3.3");
}

TEST(Sources, OptionsHaveAValueABasisAndAPlace) {
  const Table table = table_of(run_quick("sources", {}), "sources_options");
  std::set<std::string> names;
  std::set<std::string> groups;
  std::string last;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string option = cell(table, row, "option");
    EXPECT_TRUE(names.insert(option).second) << option;
    EXPECT_FALSE(cell(table, row, "value").empty()) << option;
    EXPECT_FALSE(cell(table, row, "where").empty()) << option;
    const std::string group = cell(table, row, "group");
    EXPECT_TRUE(group == last || groups.insert(group).second) << option << ": not by group";
    last = group;
  }
  for (const char* const option : {"midpoint",
                                   "c_vertex",
                                   "axis_from of soms",
                                   "axis_from of spatial_median",
                                   "empty_side",
                                   "level of the objects",
                                   "level of the urban scene",
                                   "root_level",
                                   "per_leaf",
                                   "ties on the axis",
                                   "side of the plane",
                                   "generic traversal",
                                   "Larsson's traversal",
                                   "E-Node",
                                   "descent of E-Node",
                                   "order of E-Node",
                                   "start of E-Node",
                                   "drive",
                                   "offsets",
                                   "scale of the object",
                                   "balanced level",
                                   "nodes with one triangle"}) {
    EXPECT_TRUE(names.contains(option)) << option;
  }
}

TEST(Sources, ValuesAreThoseOfTheRuns) {
  const Table table = table_of(run_quick("sources", {}), "sources_options");
  const auto value = [&](const std::string& option) {
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      if (cell(table, row, "option") == option) {
        return cell(table, row, "basis") + ": " + cell(table, row, "value");
      }
    }
    return std::string();
  };
  EXPECT_EQ(value("midpoint"), "caption: thesis");
  EXPECT_EQ(value("c_vertex"), "ours: 2");
  EXPECT_EQ(value("axis_from of soms"), "stated: inner");
  EXPECT_EQ(value("per_leaf"), "ours: 1");
  EXPECT_EQ(value("kind of tree"), "stated: binary, of boxes along the axes");
  EXPECT_EQ(value("nodes with one triangle"), "stated: leaves with exactly one triangle");
  EXPECT_EQ(value("axis_from of spatial_median"), "ours: outer");
  EXPECT_EQ(value("empty_side"), "ours: stop");
  EXPECT_EQ(value("level of the objects"), "caption: 15");
  EXPECT_EQ(value("level of the urban scene"), "caption: 13");
  EXPECT_EQ(value("directions"), "stated: right, left, top, bottom");
  EXPECT_EQ(value("right"), "ours: comes from +x");
  EXPECT_EQ(value("top"), "ours: comes from +y");
  EXPECT_EQ(value("offsets"),
            "ours: 49 frames, 2 to 0.5 widths of the still object, -0.03125 a frame");
  EXPECT_EQ(value("drive"), "ours: 221 frames from (-200, 2000, -16) to (4200, 2000, -16)");
  EXPECT_EQ(value("scale of the object"),
            "ours: 500 times as large as its file; other objects as long as that");
}

TEST(Sources, ContradictionsNameBothPlaces) {
  EXPECT_GE(contradictions().size(), 13U);
  std::set<std::string_view> subjects;
  for (const Contradiction& one : contradictions()) {
    EXPECT_TRUE(subjects.insert(one.subject).second) << one.subject;
    EXPECT_FALSE(one.one.empty() || one.other.empty() || one.outcome.empty()) << one.subject;
  }
  EXPECT_TRUE(subjects.contains("pages of the appendices"));
}

TEST(Sources, UnjudgedStatementsSayWhyAndNameItems) {
  const Table table = table_of(run_quick("sources", {}), "sources_unjudged");
  ASSERT_EQ(table.rows.size(), unjudged_statements().size());
  for (const UnjudgedStatement& one : unjudged_statements()) {
    EXPECT_FALSE(one.words.empty() || one.where.empty() || one.why.empty()) << one.words;
    if (!one.item.empty()) {
      const std::array words{one.item};
      EXPECT_EQ(experiments_named(words).size(), 1U) << one.item;
    }
  }
  EXPECT_EQ(cell(table, 0, "where"), "section 1.6");
}

TEST(Sources, RestatementsSayWhatTheySettle) {
  const Table table = table_of(run_quick("sources", {}), "sources_restatements");
  ASSERT_EQ(table.rows.size(), restatements().size());
  for (const Restatement& one : restatements()) {
    EXPECT_FALSE(one.text.empty() || one.says.empty() || one.settles.empty()) << one.text;
  }
}

TEST(Sources, TheRemarkCountsWhatTheTableSays) {
  const Result result = run_quick("sources", {});
  const Table table = table_of(result, "sources_options");
  std::map<std::string, int> bases;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    ++bases[cell(table, row, "basis")];
  }
  const std::string counts =
      fmt::format("Of {} options {} are stated, {} follow from a caption or heading, {} are ours.",
                  table.rows.size(), bases["stated"], bases["caption"], bases["ours"]);
  EXPECT_NE(result.remarks.at(0).find(counts), std::string::npos) << result.remarks.at(0);
}

}  // namespace
}  // namespace soms::reproduce
