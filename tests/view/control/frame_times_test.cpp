#include "apps/view/control/frame_times.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(FrameTimes, GraphEndsWithTheNewestFrame) {
  FrameTimes times;
  for (int i = 1; i <= 130; ++i) {
    times.add(i, 0.02);
  }
  const auto graph = times.graph();
  EXPECT_EQ(graph.front(), 11.0F);
  EXPECT_EQ(graph.back(), 130.0F);
  EXPECT_EQ(times.last(), 130);
  EXPECT_EQ(times.greatest(), 130);
  EXPECT_DOUBLE_EQ(times.mean(), (11 + 130) / 2.0);
}

TEST(FrameTimes, MeanIsOfTheFramesThatThereAre) {
  FrameTimes times;
  EXPECT_EQ(times.mean(), 0);
  times.add(4, 0.02);
  times.add(8, 0.02);
  EXPECT_EQ(times.mean(), 6);
}

TEST(FrameTimes, CountsFramesASecondFromTheLastRest) {
  FrameTimes times;
  EXPECT_EQ(times.frames_a_second(), 0);
  for (int i = 0; i < 10; ++i) {
    times.add(5, 0.1);
  }
  EXPECT_NEAR(times.frames_a_second(), 10, 1e-9);
  times.add(5, 3);  // nothing happened for three seconds
  EXPECT_EQ(times.frames_a_second(), 0);
  for (int i = 0; i < 40; ++i) {
    times.add(5, 0.05);
  }
  EXPECT_NEAR(times.frames_a_second(), 20, 1e-9);
}

}  // namespace
}  // namespace soms::view
