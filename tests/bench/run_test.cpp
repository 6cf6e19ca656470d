// Libraries under test that lie must not win: their ratios are void, and the table says so.
#include "bench/peers/run.h"

#include "bench/peers/core/tables.h"
#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

#include <fstream>
#include <sstream>

namespace soms::bench {
namespace {

/// Right answers but at the poses `lies`, and quicker the fewer of them it works out.
class FakeMatch final : public Match {
 public:
  FakeMatch(const FloatMesh& mover, const FloatMesh& fixed, std::size_t lies)
      : counter_(mover, fixed), lies_(lies) {}

  void answer(const Questions& questions, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const bool lie = i < lies_;
      answers[i] =
          static_cast<double>(counter_.count(questions.poses[i], questions.job == Job::any));
      answers[i] = lie ? (answers[i] == 0 ? 1 : answers[i] - 1) : answers[i];
    }
  }

 private:
  PairCounter counter_;
  std::size_t lies_;
};

class Fake final : public Library {
 public:
  Fake(std::string name, std::size_t lies) : name_(std::move(name)), lies_(lies) {}

  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] std::string version() const override { return "0"; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any || job == Job::all; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                               const FloatMesh& fixed) const override {
    return std::make_unique<FakeMatch>(mover, fixed, lies_);
  }

 private:
  std::string name_;
  std::size_t lies_;
};

constexpr std::size_t kQuestions = 100;

Scene cubes() {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  Scene scene{"cubes", cube, cube, {{"row", {}, {Job::any, Job::all}}}};
  for (std::size_t i = 0; i < kQuestions; ++i) {
    scene.sets[0].poses.push_back(Pose::translation(0.04 * static_cast<double>(i), 0.1, 0.2));
  }
  return scene;
}

std::vector<Cell> run_fakes(const std::vector<std::pair<std::string, std::size_t>>& fakes,
                            double judge = 1e6) {
  Roster roster;
  for (const auto& [name, lies] : fakes) {
    roster.push_back(std::make_unique<Fake>(name, lies));
  }
  RunOptions options;
  options.race = {.rounds = 1, .budget = 10, .least_pass = 0};
  options.judge = judge;
  std::vector<Cell> cells;
  run_scene(cubes(), roster, options, [&](Cell cell) { cells.push_back(std::move(cell)); });
  return cells;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(RunScene, RanksLibrariesThatTellTheTruth) {
  const auto cells = run_fakes({{"peer", 0}, {"soms", 0}});
  ASSERT_EQ(cells.size(), 2U);
  for (const Cell& cell : cells) {
    EXPECT_EQ(cell.questions, kQuestions);
    EXPECT_EQ(cell.entries[1].verdict.checked, kQuestions);
    EXPECT_TRUE(ratio(cell, "soms").has_value());
    EXPECT_GT(cell.sum, 10U);
  }
  EXPECT_TRUE(sound(cells));
}

TEST(RunScene, VoidsTheRatioOfSomsAtOneWrongAnswer) {
  for (const double judge : {1e6, 1.0}) {
    const auto cells = run_fakes({{"peer", 0}, {"soms", 1}, {"soms-batch", 0}}, judge);
    for (const Cell& cell : cells) {
      EXPECT_EQ(cell.entries[1].verdict.wrong_questions, std::vector<std::size_t>{0});
      EXPECT_FALSE(ratio(cell, "soms").has_value());
      EXPECT_TRUE(ratio(cell, "soms-batch").has_value());
    }
    EXPECT_FALSE(sound(cells));
  }
}

TEST(RunScene, CatchesALieThatAllTell) {
  const auto cells = run_fakes({{"peer", 5}, {"soms", 5}});
  for (const Cell& cell : cells) {
    EXPECT_EQ(cell.entries[1].verdict.wrong, 5U);
    EXPECT_FALSE(ratio(cell, "soms").has_value());
    EXPECT_EQ(best_peer(cell), nullptr);
  }
}

TEST(RunScene, DoesNotRankAPeerThatIsWrongOften) {
  const auto cells = run_fakes({{"liar", 3}, {"rounder", 2}, {"soms", 0}});
  for (const Cell& cell : cells) {
    EXPECT_FALSE(ranked(cell, cell.entries[0]));
    EXPECT_TRUE(ranked(cell, cell.entries[1]));
    ASSERT_NE(best_peer(cell), nullptr);
    EXPECT_EQ(best_peer(cell)->library, "rounder");
  }
  EXPECT_TRUE(sound(cells));
}

TEST(MedianRatio, IsOfAllRowsAndVoidWithOne) {
  const auto cell = [](const std::string& scene, double soms, bool right) {
    Cell made;
    made.scene = scene;
    made.questions = 1;
    for (const auto& [library, seconds] :
         {std::pair<std::string, double>{"peer", 12}, {"soms", soms}}) {
      Entry entry;
      entry.library = library;
      entry.answered = 1;
      entry.timing.median = seconds;
      entry.verdict.wrong = library == "soms" && !right ? 1 : 0;
      made.entries.push_back(entry);
    }
    return made;
  };
  const MedianGoal goal{Job::any, "unlike", "soms", 5};
  std::vector<Cell> cells{cell("unlike-a", 1, true), cell("unlike-b", 4, true),
                          cell("unlike-c", 2, true), cell("twins", 0.1, true)};
  EXPECT_EQ(median_ratio(cells, goal).rows, 3U);
  EXPECT_EQ(median_ratio(cells, goal).ratio, 6);
  cells.push_back(cell("unlike-d", 3, true));
  EXPECT_EQ(median_ratio(cells, goal).ratio, 5);
  const test::TemporaryFolder folder;
  write_markdown(folder.path() / "a.md", cells, {.isa = "avx512", .selection = "all"});
  EXPECT_NE(text_of(folder.path() / "a.md").find("| any | unlike | 4 | soms | 5.00 | 5.0 | met |"),
            std::string::npos);
  cells.push_back(cell("unlike-e", 3, false));
  EXPECT_FALSE(median_ratio(cells, goal).ratio.has_value());
  EXPECT_EQ(median_ratio({}, goal).rows, 0U);
}

TEST(RunScene, SaysSoInItsTables) {
  const auto cells = run_fakes({{"peer", 0}, {"soms", 1}});
  const test::TemporaryFolder folder;
  write_markdown(folder.path() / "a.md", cells, {});
  write_csv(folder.path() / "a.csv", cells);
  const std::string page = text_of(folder.path() / "a.md");
  EXPECT_NE(page.find("| void |"), std::string::npos) << page;
  EXPECT_NE(page.find("soms is wrong in 1 of 100, first at pose 0"), std::string::npos) << page;
  EXPECT_NE(page.find("wrong in 1 of 100: void"), std::string::npos) << page;
  const auto rows = test::read_csv(folder.path() / "a.csv");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].back(), "ratio");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].back().empty(), rows[i][7] == "soms") << i;
  }
  std::ostringstream json;
  print_json(json, cells);
  EXPECT_NE(json.str().find("\"wrong\":1,\"ratio\":null"), std::string::npos);
}

TEST(RunScene, ComparesSomsWithBruteForceInEveryJob) {
  Roster roster;
  add_soms(roster);
  RunOptions options;
  options.race = {.rounds = 1, .budget = 1, .least_pass = 0};
  Scene scene = cubes();
  scene.sets[0].still = 3;
  scene.sets[0].jobs = kEveryPoseJob;
  std::vector<Cell> cells;
  run_scene(scene, roster, options, [&](Cell cell) { cells.push_back(std::move(cell)); });
  std::vector<std::string> queried;
  for (const Cell& cell : cells) {
    queried.push_back(name(cell.job) + " " + cell.set);
  }
  EXPECT_EQ(queried,
            (std::vector<std::string>{"any row", "all row", "distance row", "within half row",
                                      "within 0.99 row", "within 1.01 row", "still row"}));
  EXPECT_EQ(cells.back().questions, 3U);
  EXPECT_TRUE(sound(cells));
}

// A cube of side 2: a point at (3, 0, 0) is 2 from it, (0, 0, 0.5) within it, half a unit deep.
TEST(RunScene, ComparesSomsWithBruteForceForProbes) {
  Roster roster;
  add_soms(roster);
  RunOptions options;
  options.race = {.rounds = 1, .budget = 1, .least_pass = 0};
  Scene scene{"cube", {}, box({0, 0, 0}, {1, 1, 1}), {}};
  scene.probe_sets = {{"points", {{3, 0, 0}, {0, 0, 0.5}}, {}, {Job::closest, Job::contains}}};
  std::vector<Cell> cells;
  run_scene(scene, roster, options, [&](Cell cell) { cells.push_back(std::move(cell)); });
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(name(cells[0].job), "closest");
  EXPECT_EQ(cells[0].sum, 2.5);
  EXPECT_EQ(name(cells[1].job), "contains");
  EXPECT_EQ(cells[1].sum, 1);
  for (const Cell& cell : cells) {
    EXPECT_EQ(cell.questions, 2U);
    ASSERT_EQ(cell.entries.size(), 2U);  // alone and in a batch
    EXPECT_EQ(cell.entries[1].library, "soms-batch");
    EXPECT_EQ(question(cell.job), "point");
    EXPECT_GT(ratio(cell, "soms", Against::clock).value_or(0), 0);
  }
  EXPECT_TRUE(sound(cells));
}

// Cubes touch up to x = 2: the distances of the 49 poses beyond are their x less 2.
TEST(RunScene, AsksForClearancesWhereThereIsOne) {
  Roster roster;
  add_soms(roster);
  RunOptions options;
  options.jobs = {Job::distance, Job::within};
  options.race = {.rounds = 1, .budget = 1, .least_pass = 0};
  Scene scene = cubes();
  scene.sets[0].jobs = kEveryPoseJob;
  std::vector<Cell> cells;
  run_scene(scene, roster, options, [&](Cell cell) { cells.push_back(std::move(cell)); });
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[0].questions, kQuestions);
  EXPECT_NEAR(cells[0].sum, 49 * 0.04 * 25, 1e-9);
  for (const auto& [cell, near] : {std::pair{1, 0.0}, {2, 0.0}, {3, 49.0}}) {
    const Cell& within = cells[static_cast<std::size_t>(cell)];
    EXPECT_EQ(within.questions, 49U);
    EXPECT_EQ(within.sum, near) << within.set;
    EXPECT_EQ(within.entries.size(), 2U);
    EXPECT_EQ(best_peer(within), nullptr);
    ASSERT_NE(best_peer(within, Against::by_distance), nullptr);
    EXPECT_TRUE(ratio(within, "soms", Against::by_distance).has_value());
  }
  EXPECT_TRUE(sound(cells));
}

// Crossing up to x = 2, clear beyond.
TEST(RunScene, MeasuresSolidsByTheOverlap) {
  Roster roster;
  add_soms(roster);
  RunOptions options;
  options.jobs = {Job::solid};
  options.race = {.rounds = 1, .budget = 10, .least_pass = 0};
  Scene scene = cubes();
  scene.sets[0].jobs = {Job::solid};
  std::vector<Cell> cells;
  run_scene(scene, roster, options, [&](Cell cell) { cells.push_back(std::move(cell)); });
  ASSERT_EQ(cells.size(), 1U);
  const Cell& cell = cells.front();
  ASSERT_EQ(cell.entries.size(), 4U);
  for (const Entry& entry : cell.entries) {
    EXPECT_EQ(entry.answered, kQuestions) << entry.library;
    EXPECT_EQ(entry.verdict.checked, kQuestions) << entry.library;
    EXPECT_EQ(entry.verdict.wrong, 0U) << entry.library;
  }
  EXPECT_EQ(best_peer(cell), nullptr);
  EXPECT_EQ(best_peer(cell, Against::by_overlap)->library, kByOverlap);
  EXPECT_EQ(best_peer(cell, Against::by_overlap_batch)->library, kByOverlapBatch);
  EXPECT_TRUE(ratio(cell, "soms", Against::by_overlap).has_value());
  EXPECT_TRUE(ratio(cell, "soms-batch", Against::by_overlap_batch).has_value());
}

}  // namespace
}  // namespace soms::bench
