// Each verdict of a run, computed again from the CSV of its matrix by the rule that the page
// states.
#include "tests/commands/run.h"
#include "tests/support/slow_build.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace soms::test {
namespace {

/// How the rows of a matrix stand.
struct Tally {
  int hold = 0;
  int fail = 0;
  int open = 0;
  /// By metric, reading and demand: whether each row so far holds.
  std::map<std::string, bool> lines = {};

  [[nodiscard]] bool has_whole_line() const {
    return std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.second; });
  }
};

double number_or(const std::string& cell, double otherwise) {
  return cell.empty() ? otherwise : std::stod(cell);
}

Tally tally_of(const std::filesystem::path& matrix) {
  const std::vector<std::vector<std::string>> lines = read_csv(matrix);
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < lines.at(0).size(); ++i) {
    columns[lines[0][i]] = i;
  }
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  Tally tally;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const auto cell = [&](const char* column) { return lines[k].at(columns.at(column)); };
    if (!cell("unjudged").empty()) {
      EXPECT_EQ(cell("stands"), "not judged");
      continue;
    }
    const double value = std::stod(cell("value"));
    const double low = number_or(cell("low"), value);
    const double high = number_or(cell("high"), value);
    const double above = number_or(cell("above"), -kEnd);
    const double below = number_or(cell("below"), kEnd);
    EXPECT_TRUE(above > -kEnd || below < kEnd) << matrix << " row " << k << " demands nothing";
    EXPECT_LE(low, high);
    const bool inside = low > above && high < below;
    const bool outside = high <= above || low >= below;
    EXPECT_EQ(cell("stands"), inside    ? "holds"
                              : outside ? "fails"
                                        : "undecided")
        << matrix << " row " << k;
    const std::string line =
        cell("metric") + "|" + cell("reading") + "|" + cell("above") + "|" + cell("below");
    tally.lines.try_emplace(line, true).first->second &= inside;
    ++(inside ? tally.hold : outside ? tally.fail : tally.open);
  }
  return tally;
}

std::string verdict_by_the_rule(const Tally& tally) {
  if (tally.hold + tally.fail + tally.open == 0) {
    return "cannot be checked";
  }
  if (tally.fail + tally.open == 0) {
    return "holds in all readings";
  }
  if (tally.hold > 0) {
    return tally.has_whole_line() ? "holds under some readings" : "holds on some subjects";
  }
  return tally.open > 0 ? "undecided" : "does not hold in any reading";
}

/// The words in the badge of a claim's row on the page.
std::string verdict_on_page(const std::string& page, const std::string& id) {
  const std::size_t row = page.find("<tr id=\"claim-" + id + "\"");
  const std::size_t badge = page.find("<span class=\"badge ", row);
  const std::size_t begin = page.find("; ", badge) + 2;  // after the sign, an entity
  return row == std::string::npos ? "" : page.substr(begin, page.find("</span>", begin) - begin);
}

/// One run of claims, as each takes its time, for all that is checked of it.
class Claims : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (kSlowBuild) {
      return;
    }
    folder_.emplace();
    std::vector<std::string> words{"reproduce",
                                   "--quick",
                                   "--item",
                                   "claim-models,claim-fallback,claim-single-leaves,"
                                   "claim-26-percent,claim-balance,claim-level-7",
                                   "-o",
                                   folder().string()};
    if (const auto models = outside_data("")) {
      words.insert(words.end(), {"--models", models->string()});
    }
    const RunResult result = soms_run(words);
    ASSERT_EQ(result.status, 0) << result.err;
  }

  static void TearDownTestSuite() { folder_.reset(); }

  [[nodiscard]] static const std::filesystem::path& folder() { return folder_->path(); }

  [[nodiscard]] static Json run() { return Json::parse(read_text(folder() / "run.json")); }

 private:
  static inline std::optional<TemporaryFolder> folder_;
};

TEST_F(Claims, VerdictOfEachFollowsFromItsCsvByTheRule) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Json run_file = run();
  const std::string page = read_text(folder() / "index.html");
  int claims = 0;
  for (const Json& item : run_file.at("items")) {
    for (const Json& claim : item.at("claims")) {
      const std::string id = claim.at("id");
      const Tally tally = tally_of(folder() / std::string(claim.at("matrix")));
      EXPECT_EQ(claim.at("verdict"), verdict_by_the_rule(tally)) << id;
      EXPECT_EQ(verdict_on_page(page, id), verdict_by_the_rule(tally)) << id;
      EXPECT_EQ(claim.at("verdict") == "cannot be checked",
                tally.hold + tally.fail + tally.open == 0);
      ++claims;
    }
  }
  EXPECT_GE(claims, 2);
}

TEST_F(Claims, VerdictsInTheDocumentationAreThoseOfARun) {
  SOMS_NEEDS_OUTSIDE_DATA("the verdicts in docs/reproduce.md: they need the bunny");
  SOMS_SKIP_IN_SLOW_BUILDS();
  const std::string page = read_text(std::string(SOMS_DOCS) + "/reproduce.md");
  const Json run_file = run();
  for (const Json& item : run_file.at("items")) {
    for (const Json& claim : item.at("claims")) {
      const std::string row =
          "| " + std::string(claim.at("claim")) + " | " + std::string(claim.at("verdict")) + " | ";
      EXPECT_NE(page.find(row), std::string::npos) << row;
      const std::string where = claim.at("where");
      if (where.starts_with("Holds in ")) {
        const std::string share = where.substr(9, where.find_first_of(".,") - 9);
        EXPECT_NE(page.find(row + share), std::string::npos) << row << share;
      }
    }
  }
}

}  // namespace
}  // namespace soms::test
