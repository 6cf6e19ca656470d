// Both verdicts of each claim of a run, computed again from the CSV of its matrix by the rules that
// the page states; and the verdicts in the documentation.
#include "tests/commands/run.h"
#include "tests/support/slow_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace soms::test {
namespace {

constexpr std::size_t kLeast = 3;  ///< subjects of a comparison, and rows

/// The rows of one metric, reading and demand.
struct MatrixLine {
  std::size_t rows = 0;
  std::size_t hold = 0;
  std::set<std::string> subjects = {};
};

/// How some rows stand.
struct Stands {
  std::size_t hold = 0;
  std::size_t fail = 0;
  std::size_t open = 0;
  std::set<std::string> subjects = {};

  [[nodiscard]] std::size_t judged() const { return hold + fail + open; }
};

/// How the rows of a matrix stand.
struct Tally {
  Stands all = {};
  Stands nearest = {};
  Stands counted = {};   ///< of the nearest rows, those that count
  Stands measured = {};  ///< and those that measure
  std::size_t on_stand_ins = 0;
  std::size_t would_hold = 0;
  std::map<std::string, MatrixLine> lines = {};

  [[nodiscard]] bool has_whole_lines(bool comparison) const {
    std::size_t rows = 0;
    for (const auto& [name, line] : lines) {
      const bool enough = !comparison || line.subjects.size() >= kLeast;
      rows += line.hold == line.rows && enough ? line.rows : 0;
    }
    return rows >= kLeast;
  }
};

double number_or(const std::string& cell, double otherwise) {
  return cell.empty() ? otherwise : std::stod(cell);
}

using MatrixRow = std::map<std::string, std::string>;

std::vector<MatrixRow> rows_of(const std::filesystem::path& table) {
  const std::vector<std::vector<std::string>> lines = read_csv(table);
  std::vector<MatrixRow> rows;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    MatrixRow& row = rows.emplace_back();
    for (std::size_t i = 0; i < lines.at(0).size(); ++i) {
      row[lines[0][i]] = lines[k].at(i);
    }
  }
  return rows;
}

/// "holds", "fails" or "undecided", by the numbers of a row.
std::string stand_by_numbers(const MatrixRow& row) {
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  const double value = std::stod(row.at("value"));
  const double low = number_or(row.at("low"), value);
  const double high = number_or(row.at("high"), value);
  const double above = number_or(row.at("above"), -kEnd);
  const double below = number_or(row.at("below"), kEnd);
  EXPECT_TRUE(above > -kEnd || below < kEnd) << row.at("reading") << " demands nothing";
  EXPECT_LE(low, high);
  return low > above && high < below     ? "holds"
         : high <= above || low >= below ? "fails"
                                         : "undecided";
}

void add(Stands& stands, const std::string& stand, const std::string& subject) {
  ++(stand == "holds" ? stands.hold : stand == "fails" ? stands.fail : stands.open);
  stands.subjects.insert(subject);
}

Tally tally_of(const std::filesystem::path& matrix) {
  Tally tally;
  for (const MatrixRow& row : rows_of(matrix)) {
    const std::string stand = stand_by_numbers(row);
    if (!row.at("unjudged").empty()) {
      EXPECT_EQ(row.at("stands"), "not judged");
      const bool counts = row.at("on_stand_in") == "yes";
      tally.on_stand_ins += counts ? 1U : 0U;
      tally.would_hold += counts && stand == "holds" ? 1U : 0U;
      continue;
    }
    EXPECT_EQ(row.at("on_stand_in"), "");
    EXPECT_EQ(row.at("stands"), stand) << matrix << " " << row.at("reading");
    MatrixLine& line = tally.lines[row.at("metric") + "|" + row.at("reading") + "|" +
                                   row.at("above") + "|" + row.at("below")];
    ++line.rows;
    line.hold += stand == "holds" ? 1U : 0U;
    line.subjects.insert(row.at("subject"));
    add(tally.all, stand, row.at("subject"));
    if (row.at("nearest") == "yes") {
      add(tally.nearest, stand, row.at("subject"));
      add(row.at("low").empty() ? tally.counted : tally.measured, stand, row.at("subject"));
    }
  }
  return tally;
}

std::string verdict_by_the_rule(const Tally& tally, bool comparison) {
  const Stands& all = tally.all;
  if (all.judged() == 0) {
    return "cannot be checked";
  }
  if (all.hold == all.judged()) {
    return "holds in all readings";
  }
  if (all.hold > 0) {
    return tally.has_whole_lines(comparison) ? "holds under some readings"
                                             : "holds on some subjects";
  }
  return all.open > 0 ? "undecided" : "does not hold in any reading";
}

/// An end of the Wilson interval of 95 %: below the share for -1, above it for 1.
double wilson_end(std::size_t count, std::size_t of, int side) {
  const auto n = static_cast<double>(of);
  const double share = static_cast<double>(count) / n;
  constexpr double kZ = 1.96;
  return (share + kZ * kZ / (2 * n) +
          side * kZ * std::sqrt(share * (1 - share) / n + kZ * kZ / (4 * n * n))) /
         (1 + kZ * kZ / n);
}

std::string nearest_by_the_rule(std::size_t hold, std::size_t open, std::size_t fail,
                                std::size_t subjects, bool comparison) {
  const std::size_t judged = hold + open + fail;
  if (judged == 0) {
    return "cannot be checked";
  }
  if (comparison && (subjects < kLeast || judged < kLeast)) {
    return "too few rows";
  }
  if (hold == judged || fail == judged) {
    return hold == judged ? "holds" : "fails";
  }
  if (wilson_end(hold, judged, -1) > 0.5) {
    return "mostly holds";
  }
  if (wilson_end(hold + open, judged, 1) < 0.5) {
    return "mostly fails";
  }
  return hold > 0 && fail > 0 ? "mixed" : "undecided";
}

std::string nearest_by_the_rule(const Stands& rows, bool comparison) {
  return nearest_by_the_rule(rows.hold, rows.open, rows.fail, rows.subjects.size(), comparison);
}

/// That of all rows, but mixed if most rows hold in one kind only.
std::string nearest_of_kinds(const std::string& together, const std::string& counted,
                             const std::string& measured) {
  const auto is_judged = [](const std::string& stand) {
    return stand != "too few rows" && stand != "cannot be checked";
  };
  const auto mostly = [](const std::string& stand) {
    return stand == "holds" || stand == "mostly holds";
  };
  const bool differ =
      is_judged(counted) && is_judged(measured) && mostly(counted) != mostly(measured);
  return differ ? "mixed" : together;
}

/// The words in the badges of a claim on the page, in their order.
std::vector<std::string> verdicts_on_page(const std::string& page, const std::string& id) {
  std::vector<std::string> words;
  const std::size_t anchor = page.find("id=\"claim-" + id + "\"");
  const std::size_t row = page.rfind("<details", anchor);
  const std::size_t end = page.find("</details>", anchor);
  for (std::size_t at = page.find("<span class=\"badge ", row); at < end;
       at = page.find("<span class=\"badge ", at + 1)) {
    const std::size_t begin = page.find("; ", at) + 2;  // after the sign, an entity
    words.push_back(page.substr(begin, page.find("</span>", begin) - begin));
  }
  return words;
}

/// "holds, 7 of 7", or the words alone if nothing is judged: a cell of the documentation.
std::string verdict_cell(const std::string& words, std::size_t hold, std::size_t judged) {
  return judged == 0 ? words : fmt::format("{}, {} of {}", words, hold, judged);
}

std::string documented_row(const std::string& claim, const std::string& nearest,
                           const std::string& all) {
  return fmt::format("| {} | {} | {} | ", claim, nearest, all);
}

/// The verdicts of the run that docs/reproduce.md describes.
std::vector<MatrixRow> recorded_verdicts() {
  return rows_of(data("thesis/results_of_docs.csv"));
}

std::string documentation() {
  return read_text(std::string(SOMS_DOCS) + "/reproduce.md");
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

TEST_F(Claims, BothVerdictsOfEachFollowFromItsCsvByTheRules) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Json run_file = run();
  const std::string page = read_text(folder() / "index.html");
  int claims = 0;
  for (const Json& item : run_file.at("items")) {
    for (const Json& claim : item.at("claims")) {
      const std::string id = claim.at("id");
      SCOPED_TRACE(id);
      const Tally tally = tally_of(folder() / std::string(claim.at("matrix")));
      const bool comparison = claim.at("scope") == "comparison";
      const std::string verdict = verdict_by_the_rule(tally, comparison);
      const Stands& near = tally.nearest;
      const std::string nearest = nearest_of_kinds(nearest_by_the_rule(near, comparison),
                                                   nearest_by_the_rule(tally.counted, comparison),
                                                   nearest_by_the_rule(tally.measured, comparison));
      EXPECT_EQ(claim.at("verdict"), verdict);
      EXPECT_EQ(claim.at("judged"), tally.all.judged());
      EXPECT_EQ(claim.at("hold"), tally.all.hold);
      EXPECT_EQ(verdicts_on_page(page, id), (std::vector<std::string>{nearest, verdict}));
      const Json& of_run = claim.at("nearest");
      EXPECT_EQ(of_run.at("verdict"), nearest);
      EXPECT_EQ(of_run.at("rows"), near.judged());
      EXPECT_EQ(of_run.at("hold"), near.hold);
      EXPECT_EQ(of_run.at("undecided"), near.open);
      EXPECT_EQ(of_run.at("fail"), near.fail);
      EXPECT_EQ(of_run.at("subjects"), near.subjects.size());
      EXPECT_EQ(of_run.at("counted").at("hold"), tally.counted.hold);
      EXPECT_EQ(of_run.at("measured").at("hold"), tally.measured.hold);
      EXPECT_FALSE(std::string(of_run.at("options")).empty());
      EXPECT_FALSE(std::string(of_run.at("why")).empty());
      ASSERT_EQ(of_run.at("share").is_null(), near.judged() == 0);
      if (near.judged() > 0) {
        EXPECT_NEAR(of_run.at("share").at(0), wilson_end(near.hold, near.judged(), -1), 1e-4);
        EXPECT_NEAR(of_run.at("share").at(1), wilson_end(near.hold + near.open, near.judged(), 1),
                    1e-4);
      }
      EXPECT_EQ(claim.at("on_stand_ins").at("rows"), tally.on_stand_ins);
      EXPECT_EQ(claim.at("on_stand_ins").at("hold"), tally.would_hold);
      ++claims;
    }
  }
  EXPECT_GE(claims, 2);
}

TEST_F(Claims, VerdictsInTheDocumentationAreThoseOfARun) {
  SOMS_NEEDS_OUTSIDE_DATA("the verdicts in docs/reproduce.md: they need the bunny");
  SOMS_SKIP_IN_SLOW_BUILDS();
  const std::string page = documentation();
  const Json run_file = run();
  for (const Json& item : run_file.at("items")) {
    for (const Json& claim : item.at("claims")) {
      const Json& nearest = claim.at("nearest");
      const std::string row = documented_row(
          claim.at("claim"),
          verdict_cell(nearest.at("verdict"), nearest.at("hold"), nearest.at("rows")),
          verdict_cell(claim.at("verdict"), claim.at("hold"), claim.at("judged")));
      EXPECT_NE(page.find(row), std::string::npos) << row;
    }
  }
}

// Times never decide a test: what the documentation says of them is held to a run that is kept.
TEST(ClaimsInDocs, VerdictsOfEveryClaimAreThoseOfTheRecordedRun) {
  const std::string page = documentation();
  std::size_t timed = 0;
  for (const MatrixRow& claim : recorded_verdicts()) {
    const auto count = [&](const char* column) {
      return static_cast<std::size_t>(std::stoul(claim.at(column)));
    };
    const std::size_t judged =
        count("nearest_hold") + count("nearest_undecided") + count("nearest_fail");
    const std::string row = documented_row(
        claim.at("claim"), verdict_cell(claim.at("nearest"), count("nearest_hold"), judged),
        verdict_cell(claim.at("verdict"), count("hold"), count("judged")));
    EXPECT_NE(page.find(row), std::string::npos) << row;
    EXPECT_EQ(
        claim.at("nearest"),
        nearest_of_kinds(nearest_by_the_rule(count("nearest_hold"), count("nearest_undecided"),
                                             count("nearest_fail"), count("subjects"),
                                             claim.at("scope") == "comparison"),
                         claim.at("counted"), claim.at("measured")))
        << claim.at("id");
    timed += claim.at("timed") == "yes" ? 1U : 0U;
  }
  EXPECT_GE(timed, 5U);
}

TEST(ClaimsInDocs, TableHasTheClaimsOfTheRecordedRunAndNoOther) {
  const std::string page = documentation();
  const std::size_t begin = page.find("| claim of the thesis |");
  const std::string table = page.substr(begin, page.find("\n\n", begin) - begin);
  // Two lines are its head.
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')) - 1,
            recorded_verdicts().size());
}

}  // namespace
}  // namespace soms::test
