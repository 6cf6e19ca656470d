// The comparison of a run with the golden tables.
#include "thesis/run/golden.h"

#include "soms/base/error.h"

#include "tests/reproduce/well_formed.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "thesis/page/report.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace soms::reproduce {
namespace {

std::filesystem::path golden_folder() {
  return test::data("thesis/thesis_counts.csv").parent_path();
}

/// A copy of the golden tables in which `change` edits the lines of one.
class Copy {
 public:
  template <class Change>
  Copy(std::string_view file, const Change& change) {
    for (const std::string_view name : {golden_trees().file, golden_traversals().file}) {
      std::ifstream in(golden_folder() / name);
      std::vector<std::string> lines;
      for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
      }
      if (name == file) {
        change(lines);
      }
      std::ofstream out(folder_.path() / name);
      for (const std::string& line : lines) {
        out << line << '\n';
      }
    }
  }

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  soms::test::TemporaryFolder folder_;
};

/// The rows of some models and levels only, so that a test takes moments.
GoldenTables few_rows(GoldenTables tables, std::string_view model) {
  std::erase_if(tables.trees, [&](const GoldenTree& tree) {
    return tree.model != model || tree.build.options.level != 7;
  });
  std::erase_if(tables.traversals,
                [&](const GoldenTraversal& row) { return row.trip.still != model; });
  return tables;
}

Models golden_scenes() {
  return find_models({}, {.scenes = true});
}

TEST(GoldenTables, AreReadRowByRow) {
  const GoldenTables tables = read_golden(golden_folder());
  EXPECT_EQ(tables.trees.size(), 8736U);
  EXPECT_EQ(tables.traversals.size(), 225U);
  EXPECT_EQ(tables.trees.front().row.line, 2U);
  EXPECT_EQ(tables.trees.back().row.line, 8737U);
  const auto drive =
      std::find_if(tables.traversals.begin(), tables.traversals.end(),
                   [](const GoldenTraversal& row) { return row.trip.test == "drive"; });
  ASSERT_NE(drive, tables.traversals.end());
  EXPECT_EQ(drive->trip.moving, "bunny");
}

TEST(GoldenTables, FaultsNameTheLine) {
  const std::string_view trees = golden_trees().file;
  const std::string_view traversals = golden_traversals().file;

  struct Fault {
    std::string_view file;
    std::size_t line;
    std::string text;
    std::string message;
  };

  const std::vector<Fault> faults{
      {trees, 1, "a,b", "line 1: the columns are not model,"},
      {trees, 3, "bunny,948", "line 3: 2 cells in place of 19"},
      {trees, 4, "cow,1,soms,thesis,outer,stop,1,1,1,1,1,1,1,1,1,1,1,1,1",
       "line 4: no golden model is named \"cow\""},
      {trees, 4, "bunny,1,sah,thesis,outer,stop,1,1,1,1,1,1,1,1,1,1,1,1,1",
       "line 4: no rule of the thesis is named \"sah\""},
      {trees, 5, "bunny,1,soms,thesis,outer,halt,1,1,1,1,1,1,1,1,1,1,1,1,1", "line 5: "},
      {trees, 5, "bunny,1,soms,thesis,outer,stop,1x,1,1,1,1,1,1,1,1,1,1,1,1",
       "line 5: level \"1x\" is not a number from 1 to 24"},
      {traversals, 2, "u_plain,bunny,soms,right,larger,1,1,1,1,1,1,1,1", "line 2: no test"},
      {traversals, 2, "bunny,bunny,soms,right,best,1,1,1,1,1,1,1,1",
       "line 2: no traversal is named \"best\""}};
  for (const Fault& fault : faults) {
    const Copy copy(fault.file, [&](std::vector<std::string>& lines) {
      lines.at(fault.line - 1) = fault.text;
    });
    try {
      static_cast<void>(read_golden(copy.path()));
      ADD_FAILURE() << fault.message;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_file);
      EXPECT_NE(error.place().find(std::string(fault.file) + ", " + fault.message),
                std::string::npos)
          << error.place();
      EXPECT_NE(error.remedy(), "");
    }
  }
  const Copy empty(trees, [](std::vector<std::string>& lines) { lines.clear(); });
  EXPECT_THROW(static_cast<void>(read_golden(empty.path())), Error);
}

TEST(GoldenTables, FolderWithoutThemIsAnErrorThatNamesThem) {
  const soms::test::TemporaryFolder folder;
  try {
    static_cast<void>(read_golden(folder.path() / "none"));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cannot_open);
    EXPECT_NE(error.remedy().find("thesis_traversal.csv"), std::string::npos) << error.remedy();
  }
}

TEST(Golden, EveryRowOfTheGeneratedScenesIsEqual) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const GoldenComparison found =
      compare_with_golden(read_golden(golden_folder()), golden_scenes(), {});
  EXPECT_TRUE(found.whole);
  EXPECT_EQ(found.rows(), 8961U);
  EXPECT_EQ(found.compared(), 3U * 1248U);
  EXPECT_EQ(found.different(), 0U);
  // Of the traversals all lack the bunny.
  ASSERT_EQ(found.not_given.size(), 4U);
  EXPECT_EQ(found.not_given[0].model, "bunny");
  EXPECT_EQ(found.not_given[0].rows, 1248U + 225U);
  EXPECT_EQ(summary_of(found),
            "3,744 of 8,961 rows compared, all equal; models not given, with their rows: bunny "
            "(1,473), venus (1,248), teapot_1177 (1,248), teapot (1,248)");
}

TEST(Golden, ChangedRowsAreNamedAndCountedBeyondTheFirst) {
  const Copy copy(golden_trees().file, [](std::vector<std::string>& lines) {
    for (std::string& line : lines) {
      if (line.starts_with("u_plain,5672,soms,")) {
        line.replace(line.rfind(','), std::string::npos, ",99");
      }
    }
  });
  const GoldenTables tables = few_rows(read_golden(copy.path()), "u_plain");
  const GoldenComparison found = compare_with_golden(tables, golden_scenes(), {});
  const auto changed = static_cast<std::size_t>(
      std::count_if(tables.trees.begin(), tables.trees.end(),
                    [](const GoldenTree& tree) { return tree.build.name == "soms"; }));
  EXPECT_GT(changed, kMostDifferences);
  EXPECT_EQ(found.different(), changed);
  EXPECT_EQ(found.compared(), tables.trees.size());
  ASSERT_EQ(found.differences.size(), kMostDifferences);
  const std::string sentence = sentence_of(found.differences.front());
  EXPECT_EQ(sentence.find("thesis_counts.csv, line "), 0U) << sentence;
  EXPECT_NE(sentence.find(": u_plain 5672 soms thesis outer stop level 7: balanced_level 99, here"),
            std::string::npos)
      << sentence;
  const std::string html = markup_of(found);
  EXPECT_EQ(test::count_of(html, "class=\"warn\""), 1U);
  EXPECT_EQ(test::count_of(html, "<li>"), kMostDifferences);
  EXPECT_EQ(test::count_of(html, "The first 20 differences"), 1U);
}

TEST(Golden, PageAndManifestHaveTheComparison) {
  Report report;
  EXPECT_EQ(test::count_of(page(report), "id=\"golden\""), 0U);
  EXPECT_EQ(test::count_of(manifest(report), "\"golden\": null"), 1U);
  report.golden = {.files = {{"thesis_counts.csv", 10, 4, 0}}, .not_given = {{"venus", 6}}};
  const std::string html = page(report);
  EXPECT_EQ(test::markup_fault(html, {"meta", "link", "br"}), "");
  EXPECT_EQ(test::count_of(html, "4 of 10 rows compared, all equal; models not given"), 1U);
  EXPECT_EQ(test::count_of(html, "class=\"warn\""), 0U);
  EXPECT_EQ(test::count_of(manifest(report), "\"models_not_given\""), 1U);
}

TEST(Golden, StopRequestEndsTheComparisonWhichSaysSo) {
  std::stop_source stop;
  std::vector<double> shares;
  Limits limits{.stop = stop.get_token(), .progress = [&](double share) {
                  shares.push_back(share);
                  if (shares.size() == 3) {
                    stop.request_stop();
                  }
                }};
  const GoldenTables tables = few_rows(read_golden(golden_folder()), "u_plain");
  const GoldenComparison found = compare_with_golden(tables, golden_scenes(), limits);
  EXPECT_FALSE(found.whole);
  EXPECT_EQ(found.compared(), 3U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_NE(summary_of(found).find("stopped before the last row"), std::string::npos);
}

}  // namespace
}  // namespace soms::reproduce
