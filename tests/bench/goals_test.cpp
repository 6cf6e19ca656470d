#include "bench/peers/core/goals.h"

#include "soms/query/instruction_set.h"

#include "bench/peers/core/machine.h"

#include <gtest/gtest.h>

#include <tuple>

namespace soms::bench {
namespace {

double goal(const std::vector<Goal>& goals, const std::string& library) {
  for (const Goal& g : goals) {
    if (g.library == library) {
      return g.times;
    }
  }
  return 0;
}

TEST(Goals, DependOnTheSizeOfNearMisses) {
  for (const auto& [triangles, any, batch] :
       {std::tuple{10'000, 6.0, 8.0}, {100'000, 4.5, 6.0}, {1'000'000, 4.0, 5.0}}) {
    const auto goals = goals_of(Job::any, "twins-knot", "near-0.001",
                                static_cast<std::uint64_t>(triangles), "avx512");
    EXPECT_EQ(goal(goals, "soms"), any) << triangles;
    EXPECT_EQ(goal(goals, "soms-batch"), batch) << triangles;
  }
}

TEST(Goals, AreHalfWithoutTheWidestInstructions) {
  EXPECT_EQ(goal(goals_of(Job::any, "city-car", "car", 5'672, "avx2"), "soms"), 2.5);
}

TEST(Goals, TellAFlightFromPlacesInTheStreets) {
  EXPECT_EQ(goal(goals_of(Job::any, "city-drone", "drone", 5'672, "avx512"), "soms"), 3);
  EXPECT_EQ(goal(goals_of(Job::any, "city-drone", "drone-path", 5'672, "avx512"), "soms"), 2);
  EXPECT_EQ(goal(goals_of(Job::any, "city-drone", "drone-path", 5'672, "avx512"), "soms-batch"), 0);
}

TEST(Goals, OfTheBroadPhaseDifferByWhatAPeerKeeps) {
  const auto goals = goals_of(Job::broad, "moving-boxes", "dense", 10'000, "avx512");
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_EQ(goals[0].against, Against::keeps_tree);
  EXPECT_EQ(goals[0].times, 2);
  EXPECT_EQ(goals[1].against, Against::from_scratch);
  EXPECT_EQ(goals[1].times, 5);
}

TEST(Goals, OfSolidsAreAboutTheOverlapAndNotHalved) {
  const auto goals = goals_of(Job::solid, "twins-knot", "random", 1'000, "avx2");
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_EQ(goals[0].library, "soms");
  EXPECT_EQ(goals[0].against, Against::by_overlap);
  EXPECT_EQ(goals[0].times, 1.0 / 3);
  EXPECT_EQ(goals[1].library, "soms-batch");
  EXPECT_EQ(goals[1].against, Against::by_overlap_batch);
  EXPECT_EQ(goals[1].times, 1.0 / 3);
}

// Against the best peer nothing is promised, but the ratio is shown.
TEST(Goals, OfClearancesAreAboutTheDistanceAndNotHalved) {
  for (const auto& [set, times] : {std::pair{"half random", 2.0}, {"0.99 random", 1.0}}) {
    const auto goals = goals_of(Job::within, "twins-knot", set, 1'000, "avx2");
    ASSERT_EQ(goals.size(), 2U) << set;
    EXPECT_EQ(goals[0].against, Against::by_distance);
    EXPECT_EQ(goals[0].times, times) << set;
    EXPECT_EQ(goals[1].against, Against::all);
    EXPECT_EQ(goals[1].times, 0);
  }
}

TEST(Goals, OfDistancesAreForPathsTooAndNoneFarApart) {
  for (const char* const library : {"soms", "soms-batch"}) {
    EXPECT_EQ(goal(goals_of(Job::distance, "twins-knot", "random", 1'000, "avx512"), library), 10);
    EXPECT_EQ(goal(goals_of(Job::distance, "city-car", "car-path", 5'672, "avx512"), library), 20);
    EXPECT_EQ(goal(goals_of(Job::distance, "real-delft-van", "near", 9, "avx512"), library), 20);
  }
  EXPECT_TRUE(goals_of(Job::distance, "far-knot", "far-3", 1'000, "avx512").empty());
}

TEST(Goals, OfPointsInBatchesBeginAtAHundredThousand) {
  for (const auto& [scene, alone, batch] :
       {std::tuple{"probe-knot", 1.8, 4.0}, {"probe-city", 1.0, 2.0}}) {
    const auto small = goals_of(Job::closest, scene, "random", 10'000, "avx512");
    EXPECT_EQ(goal(small, "soms"), alone) << scene;
    EXPECT_EQ(goal(small, "soms-batch"), 0) << scene;
    EXPECT_EQ(goal(goals_of(Job::closest, scene, "path", 100'000, "avx512"), "soms-batch"), batch);
  }
}

TEST(Goals, OfContainmentAreAlsoMillionsASecond) {
  const auto goals = goals_of(Job::contains, "probe-igea", "random", 268'686, "avx512");
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_EQ(goals[0].times, 6);
  EXPECT_EQ(goals[1].against, Against::clock);
  EXPECT_EQ(goals[1].times, 3);
}

TEST(Goals, OfUnlikePairsAreForEachRowOfAllAndForMedians) {
  for (const char* const set : {"random", "grazing"}) {
    EXPECT_EQ(goal(goals_of(Job::all, "unlike-ship-cow", set, 5'804, "avx512"), "soms"), 4);
    EXPECT_EQ(goal(goals_of(Job::any, "unlike-ship-cow", set, 5'804, "avx512"), "soms"), 0);
  }
  const auto medians = median_goals("avx512");
  ASSERT_EQ(medians.size(), 2U);
  EXPECT_EQ(medians[0].job, Job::any);
  EXPECT_EQ(medians[0].times, 5);
  EXPECT_EQ(medians[1].job, Job::all);
  EXPECT_EQ(medians[1].times, 6);
  EXPECT_EQ(median_goals("avx2")[1].times, 3);
}

TEST(Goals, AreNoneForAJobThatNoneWasSetFor) {
  EXPECT_TRUE(goals_of(Job::any, "streets", "routes", 5'672, "avx512").empty());
}

// Goals and results go by what soms runs on, not by what the processor could do.
TEST(Machine, NamesTheInstructionSetThatSomsRunsOn) {
  EXPECT_EQ(isa(), instruction_set());
  EXPECT_TRUE(machine_folder().ends_with("_" + std::string(instruction_set())));
}

}  // namespace
}  // namespace soms::bench
