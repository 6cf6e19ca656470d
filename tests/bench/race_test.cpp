#include "bench/peers/core/race.h"

#include <gtest/gtest.h>

namespace soms::bench {
namespace {

/// Races on a clock that stands but for what the answers of lanes take.
class Race : public testing::Test {
 protected:
  /// Takes `seconds` an answer and answers with the question's number.
  Lane lane(const std::string& name, double seconds) {
    return {name, [this, seconds](std::span<double> answers) {
              for (std::size_t i = 0; i < answers.size(); ++i) {
                now_ += seconds;
                answers[i] = static_cast<double>(i);
              }
            }};
  }

  [[nodiscard]] RaceOptions options(int rounds, double budget) const {
    return {.rounds = rounds, .budget = budget, .least_pass = 0, .clock = [this] { return now_; }};
  }

 private:
  double now_ = 0;
};

TEST_F(Race, CutsTheSetForAllToWhatTheFastestPeerDoesInTime) {
  const std::vector<Lane> lanes{lane("soms", 1e-4), lane("peer-a", 1e-3), lane("peer-b", 2e-3)};
  const auto outcomes = race(lanes, 1000, options(1, 0.0505));
  EXPECT_EQ(outcomes[0].answers.size(), 50U);
  EXPECT_EQ(outcomes[1].answers.size(), 50U);
  EXPECT_EQ(outcomes[2].answers.size(), 50U);
  EXPECT_EQ(outcomes[0].answers.back(), 49);
}

TEST_F(Race, LetsAVerySlowLaneAnswerFewer) {
  const std::vector<Lane> lanes{lane("soms", 1e-4), lane("fast", 1e-4), lane("slow", 2e-2)};
  const auto outcomes = race(lanes, 100, options(2, 0.02));
  EXPECT_EQ(outcomes[1].answers.size(), outcomes[0].answers.size());
  EXPECT_LT(outcomes[2].answers.size(), outcomes[1].answers.size());
  EXPECT_GT(outcomes[2].timing.median, outcomes[1].timing.median);
}

// The first poses of a set may be the hardest.
TEST_F(Race, IsNotMisledByAFewSlowAnswers) {
  const auto uneven = [this](const std::string& name, double usual) {
    const Lane slow = lane(name, 2e-3);
    const Lane fast = lane(name, usual);
    return Lane{name, [slow, fast](std::span<double> answers) {
                  const std::size_t first = std::min<std::size_t>(8, answers.size());
                  slow.run(answers.first(first));
                  fast.run(answers.subspan(first));
                }};
  };
  const std::vector<Lane> lanes{lane("soms", 1e-5), lane("even", 2e-4), uneven("uneven", 1e-4)};
  const auto outcomes = race(lanes, 1000, options(3, 0.04));
  EXPECT_GE(outcomes[1].answers.size(), 190U);
  EXPECT_EQ(outcomes[2].answers.size(), outcomes[1].answers.size());
  EXPECT_LT(outcomes[2].timing.median, outcomes[1].timing.median);
}

TEST_F(Race, OrdersItsFiguresAndAnswersAlone) {
  const std::vector<Lane> lanes{lane("soms", 1e-4)};
  const auto outcomes = race(lanes, 30, options(5, 1));
  EXPECT_EQ(outcomes[0].answers.size(), 30U);
  EXPECT_LE(outcomes[0].timing.least, outcomes[0].timing.median);
  EXPECT_LE(outcomes[0].timing.median, outcomes[0].timing.most);
  EXPECT_NEAR(outcomes[0].timing.least, 1e-4, 1e-9);
}

}  // namespace
}  // namespace soms::bench
