#include "apps/view/control/view_state.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(ViewState, ClampsLevelFrameAndSpeedToWhatThereIs) {
  ViewState state;
  state.limits.city_levels = 4;
  state.limits.mover_levels = 2;
  state.limits.frames = 10;
  state.level = 9;
  state.frame = 12;
  state.speed = 1000;
  clamp(state);
  EXPECT_EQ(state.level, 4);
  EXPECT_EQ(state.frame, 9U);
  EXPECT_EQ(state.speed, kFastest);
  state.tree_of = TreeOf::mover;
  clamp(state);
  EXPECT_EQ(state.level, 2);
}

TEST(ViewState, FramesWithoutEndAreNotClamped) {
  ViewState state;
  state.frame = 1'000'000;
  clamp(state);
  EXPECT_EQ(state.frame, 1'000'000U);
}

TEST(ViewState, StopsFollowingWhenTheLastMoverIsGone) {
  ViewState state;
  state.camera = CameraMode::follow;
  state.limits.movers = 2;
  state.followed = 5;
  clamp(state);
  EXPECT_EQ(state.followed, 1U);
  EXPECT_EQ(state.camera, CameraMode::follow);
  state.limits.movers = 0;
  clamp(state);
  EXPECT_EQ(state.camera, CameraMode::orbit);
}

TEST(ViewState, ChoiceChangesWithWhatIsShownAndNotWithTime) {
  ViewState state;
  const Choice before = choice(state);
  state.frame = 7;
  state.paused = true;
  state.help = true;
  EXPECT_EQ(choice(state), before);
  state.shown.visited = true;
  EXPECT_NE(choice(state), before);
}

}  // namespace
}  // namespace soms::view
