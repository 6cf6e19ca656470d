#include "thesis/run/load.h"

#include <gtest/gtest.h>

namespace soms::reproduce {
namespace {

/// An idle machine of two processors, and a run of 100 s.
Load idle() {
  return {.start = {{0.1, 2, 3}},
          .end = {{1.1, 2, 3}},
          .processors = 2,
          .timed_seconds = 100,
          .timed_processor_seconds = 99.5};
}

TEST(Load, OfAnIdleMachineIsNone) {
  EXPECT_TRUE(signs_of_load(idle()).empty());
}

TEST(Load, OfOthersBeforeTheRunIsASignAboveAQuarterOfAProcessorEach) {
  Load load = idle();
  load.start = {{0.5, 0, 0}};
  EXPECT_TRUE(signs_of_load(load).empty());
  load.start = {{0.51, 0, 0}};
  ASSERT_EQ(signs_of_load(load).size(), 1U);
  EXPECT_EQ(signs_of_load(load)[0],
            "the load average of the minute before the run was 0.51 on 2 processors");
  load.processors = 64;
  EXPECT_TRUE(signs_of_load(load).empty());
  load.processors = 1;
  EXPECT_EQ(signs_of_load(load).at(0),
            "the load average of the minute before the run was 0.51 on 1 processor");
}

TEST(Load, IsUnknownWhereTheSystemDoesNotSay) {
  Load load = idle();
  load.start.reset();
  EXPECT_TRUE(signs_of_load(load).empty());
}

TEST(Load, ThatTakesProcessorTimeFromTheExperimentsIsASign) {
  Load load = idle();
  load.timed_processor_seconds = 95;
  EXPECT_TRUE(signs_of_load(load).empty());
  load.timed_processor_seconds = 80.25;
  ASSERT_EQ(signs_of_load(load).size(), 1U);
  EXPECT_EQ(signs_of_load(load)[0],
            "the experiments with times took 100.0 s and got 80.2 s of processor time (80 %)");
  load.start = {{7, 0, 0}};
  EXPECT_EQ(signs_of_load(load).size(), 2U);
}

TEST(Load, IsNotJudgedByTheShareOfAShortRun) {
  Load load = idle();
  load.timed_seconds = 0.99;
  load.timed_processor_seconds = 0.5;
  EXPECT_TRUE(signs_of_load(load).empty());
  load.timed_seconds = 1;
  EXPECT_EQ(signs_of_load(load).size(), 1U);
}

TEST(Load, DoesNotMatterToARunWithoutTimes) {
  Load load = idle();
  load.start = {{50, 50, 50}};
  load.timed_seconds = 0;
  load.timed_processor_seconds = 0;
  EXPECT_TRUE(signs_of_load(load).empty());
}

TEST(Load, ConcernsResultsWithATimedColumnOrFigure) {
  Result result;
  EXPECT_FALSE(shows_times(result));
  result.tables = {{.id = "counts", .caption = "", .columns = {{"n"}}}};
  result.figures = {{.id = "tree", .caption = "", .svg = ""}};
  EXPECT_FALSE(shows_times(result));
  result.figures[0].timed = true;
  EXPECT_TRUE(shows_times(result));
  result.figures.clear();
  result.tables[0].columns.push_back({"time", "ms", ColumnKind::timed});
  EXPECT_TRUE(shows_times(result));
}

}  // namespace
}  // namespace soms::reproduce
