#include "bench/peers/core/race.h"

#include "bench/peers/core/machine.h"

#include <gtest/gtest.h>

namespace soms::bench {
namespace {

/// Takes `seconds` of processor time an answer and answers with the question's number.
Lane lane(const std::string& name, double seconds) {
  return {name, [seconds](std::span<std::uint64_t> answers) {
            for (std::size_t i = 0; i < answers.size(); ++i) {
              const double end = processor_seconds() + seconds;
              while (processor_seconds() < end) {
              }
              answers[i] = i;
            }
          }};
}

TEST(Race, CutsTheSetForAllToWhatTheFastestRivalDoesInTime) {
  const std::vector<Lane> lanes{lane("soms", 1e-4), lane("rival-a", 1e-3), lane("rival-b", 2e-3)};
  const auto outcomes = race(lanes, 1000, {.rounds = 1, .budget = 0.05, .least_pass = 0});
  EXPECT_LE(outcomes[0].answers.size(), 50U);
  EXPECT_GE(outcomes[0].answers.size(), 20U);
  EXPECT_EQ(outcomes[1].answers.size(), outcomes[0].answers.size());
  EXPECT_EQ(outcomes[2].answers.size(), outcomes[0].answers.size());
  EXPECT_EQ(outcomes[0].answers.back(), outcomes[0].answers.size() - 1);
}

TEST(Race, LetsAVerySlowLaneAnswerFewer) {
  const std::vector<Lane> lanes{lane("soms", 1e-4), lane("fast", 1e-4), lane("slow", 2e-2)};
  const auto outcomes = race(lanes, 100, {.rounds = 2, .budget = 0.02, .least_pass = 0});
  EXPECT_EQ(outcomes[1].answers.size(), outcomes[0].answers.size());
  EXPECT_LT(outcomes[2].answers.size(), outcomes[1].answers.size());
  EXPECT_GT(outcomes[2].timing.median, outcomes[1].timing.median);
}

TEST(Race, OrdersItsFiguresAndAnswersAlone) {
  const std::vector<Lane> lanes{lane("soms", 1e-4)};
  const auto outcomes = race(lanes, 30, {.rounds = 5, .budget = 1, .least_pass = 0});
  EXPECT_EQ(outcomes[0].answers.size(), 30U);
  EXPECT_LE(outcomes[0].timing.least, outcomes[0].timing.median);
  EXPECT_LE(outcomes[0].timing.median, outcomes[0].timing.most);
  EXPECT_GE(outcomes[0].timing.least, 1e-4);
}

}  // namespace
}  // namespace soms::bench
