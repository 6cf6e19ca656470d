#include "apps/view/control/playback.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

int frames_of(Playback& playback, int ticks, double seconds, double speed) {
  int sum = 0;
  for (int i = 0; i < ticks; ++i) {
    sum += playback.due(seconds, speed);
  }
  return sum;
}

TEST(Playback, GivesSixtyFramesASecondAtAnyRateOfTicks) {
  for (const int rate : {10, 24, 60, 75, 144}) {
    Playback playback;
    EXPECT_EQ(frames_of(playback, rate, 1.0 / rate, 1), 60) << rate;
  }
}

TEST(Playback, KeepsFractionsInSlowMotion) {
  Playback playback;
  EXPECT_EQ(playback.due(1.0 / 60, 0.25), 0);
  EXPECT_EQ(playback.due(1.0 / 60, 0.25), 0);
  EXPECT_EQ(playback.due(1.0 / 60, 0.25), 0);
  EXPECT_EQ(playback.due(1.0 / 60, 0.25), 1);
}

TEST(Playback, DropsWhatItCannotCatchUpWith) {
  Playback playback;
  EXPECT_EQ(playback.due(10, 1), Playback::kMost);
  EXPECT_EQ(playback.due(0, 1), 0);
}

TEST(Playback, ForgetsItsFractionWhenReset) {
  Playback playback;
  EXPECT_EQ(playback.due(0.9 / 60, 1), 0);
  playback.reset();
  EXPECT_EQ(playback.due(0.9 / 60, 1), 0);
}

}  // namespace
}  // namespace soms::view
