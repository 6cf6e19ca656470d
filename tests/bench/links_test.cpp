// An arm's links are queried in turn, by soms, its peers and the judge.
#include "bench/peers/links.h"

#include "bench/peers/run.h"
#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

namespace soms::bench {
namespace {

/// Two pairs touch at poses left of x = 1; remembers how many of them each call was about.
class Counting final : public Match {
 public:
  explicit Counting(std::vector<std::size_t>& calls) : calls_(calls) {}

  void answer(const Questions& questions, std::span<double> answers) override {
    calls_.push_back(answers.size());
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const bool touches = questions.poses[i].m[3] < 1;
      answers[i] = !touches ? 0 : questions.job == Job::any ? 1 : 2;
    }
  }

 private:
  std::vector<std::size_t>& calls_;
};

/// Three configurations of two links: the first link touches, the second does, none does.
struct ThreeConfigurations {
  ThreeConfigurations() {
    for (std::size_t k = 0; k < 2; ++k) {
      matches.push_back(std::make_unique<Counting>(calls[k]));
    }
    for (const auto& [first, second] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}}) {
      poses.push_back(Pose::translation(first, 0, 0));
      poses.push_back(Pose::translation(second, 0, 0));
    }
  }

  std::vector<double> answers(Job job, bool batches) {
    std::vector<double> found(3, -1);
    Questions questions{job, poses};
    questions.links = 2;
    answer_links(matches, questions, batches, found);
    return found;
  }

  std::array<std::vector<std::size_t>, 2> calls;
  std::vector<std::unique_ptr<Match>> matches;
  std::vector<Pose> poses;
};

TEST(AnswerLinks, StopsAtTheFirstLinkThatTouches) {
  ThreeConfigurations arm;
  EXPECT_EQ(arm.answers(Job::any, false), (std::vector<double>{1, 1, 0}));
  EXPECT_EQ(arm.calls[0].size(), 3U);
  EXPECT_EQ(arm.calls[1].size(), 2U);
}

TEST(AnswerLinks, AsksInBatchesAboutWhatIsStillOpen) {
  ThreeConfigurations arm;
  EXPECT_EQ(arm.answers(Job::any, true), (std::vector<double>{1, 1, 0}));
  EXPECT_EQ(arm.calls[0], std::vector<std::size_t>{3});
  EXPECT_EQ(arm.calls[1], std::vector<std::size_t>{2});
}

TEST(AnswerLinks, AddsUpThePairsOfAllLinks) {
  for (const bool batches : {false, true}) {
    ThreeConfigurations arm;
    EXPECT_EQ(arm.answers(Job::all, batches), (std::vector<double>{4, 2, 0}));
  }
}

/// Has matches of its own body and, where it shares, of that of another.
class Sharing final : public Match {
 public:
  explicit Sharing(std::size_t& bodies) : bodies_(bodies) {}

  void answer(const Questions& /*questions*/, std::span<double> answers) override {
    std::fill(answers.begin(), answers.end(), 0.0);
  }

  [[nodiscard]] std::unique_ptr<Match> with(const FloatMesh& /*mover*/) const override {
    return std::make_unique<Sharing>(bodies_);
  }

 private:
  std::size_t& bodies_;
};

/// Counts the fixed bodies that it builds.
class Builder final : public Library {
 public:
  explicit Builder(std::size_t& bodies) : bodies_(bodies) {}

  [[nodiscard]] std::string name() const override { return "builder"; }

  [[nodiscard]] std::string version() const override { return "0"; }

  [[nodiscard]] bool does(Job job) const override { return job == Job::any || job == Job::still; }

  [[nodiscard]] std::unique_ptr<Match> prepare(const FloatMesh& /*mover*/,
                                               const FloatMesh& /*fixed*/) const override {
    ++bodies_;
    return std::make_unique<Sharing>(bodies_);
  }

 private:
  std::size_t& bodies_;
};

TEST(RunScene, BuildsTheCellOnceForAllLinks) {
  std::size_t bodies = 0;
  Roster roster;
  roster.push_back(std::make_unique<Builder>(bodies));
  RunOptions options;
  options.race = {.rounds = 1, .budget = 1, .least_pass = 0};
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  Scene scene{"arm", {}, cube, {{"row", std::vector<Pose>(6, Pose::translation(9, 0, 0))}}};
  scene.links = {cube, cube, cube};
  std::vector<Cell> cells;
  run_scene(scene, roster, options, [&](Cell cell) { cells.push_back(std::move(cell)); });
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_EQ(cells[0].questions, 2U);
  EXPECT_EQ(bodies, 1U);
}

TEST(Questions, AreCutByWholeConfigurations) {
  const std::vector<Pose> poses(12);
  Questions questions{Job::any, poses};
  questions.links = 6;
  EXPECT_EQ(questions.size(), 2U);
  EXPECT_EQ(questions.first(1).poses.size(), 6U);
  EXPECT_EQ(questions.first(1).size(), 1U);
}

// Two cubes of side 2 before a third: the first never touches, the second up to x = 2.
TEST(RunScene, ComparesSomsWithBruteForceForTheLinksOfAnArm) {
  Roster roster;
  add_soms(roster);
  RunOptions options;
  options.race = {.rounds = 1, .budget = 1, .least_pass = 0};
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  Scene scene{"arm", {}, cube, {{"row", {}, kAnyAndAll}}};
  scene.links = {cube, cube};
  for (int i = 0; i < 50; ++i) {
    scene.sets[0].poses.push_back(Pose::translation(9, 0, 0));
    scene.sets[0].poses.push_back(Pose::translation(0.08 * i, 0.1, 0.2));
  }
  std::vector<Cell> cells;
  run_scene(scene, roster, options, [&](Cell cell) { cells.push_back(std::move(cell)); });
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].questions, 50U);
  EXPECT_EQ(cells[0].sum, 26);
  EXPECT_EQ(cells[0].mover, 24U);
  EXPECT_EQ(cells[0].entries.size(), 2U);  // one by one and in a batch
  EXPECT_GT(cells[1].sum, 26);
  for (const Entry& entry : cells[0].entries) {
    EXPECT_EQ(entry.verdict.checked, 50U);
  }
  EXPECT_TRUE(sound(cells));
}

// The second link crosses the body at every pose; a library that asks the first alone is wrong.
TEST(Judge, CountsThePairsOfAllLinks) {
  const FloatMesh cube = box({0, 0, 0}, {1, 1, 1});
  const std::vector<PairCounter> links{{cube, cube}, {cube, cube}};
  std::vector<Pose> poses;
  for (int i = 0; i < 4; ++i) {
    poses.push_back(Pose::translation(9, 0, 0));
    poses.push_back(Pose::translation(0.5, 0.1 * i, 0.3));
  }
  Questions questions{Job::any, poses};
  questions.links = 2;
  const auto verdicts =
      judge(links, questions, std::vector<Answers>{{{1, 1, 1, 1}}, {{0, 0, 1, 1}}}, 1e6);
  EXPECT_EQ(verdicts[0].wrong, 0U);
  EXPECT_EQ(verdicts[1].wrong_questions, (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace soms::bench
