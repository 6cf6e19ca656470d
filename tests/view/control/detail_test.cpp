#include "apps/view/control/detail.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(Detail, DrawsEverythingBeforeAnyFrameWasTimed) {
  EXPECT_EQ(Detail().options(true, 10'000'000).most_triangles, DrawOptions::kAll);
}

TEST(Detail, DrawsEverythingWhenStillHoweverSlow) {
  Detail detail;
  detail.add(4000, 1'000'000);
  EXPECT_EQ(detail.options(false, 1'000'000).most_triangles, DrawOptions::kAll);
  EXPECT_EQ(detail.options(false, 1'000'000).samples, DrawOptions{}.samples);
}

TEST(Detail, DrawsWhatFitsTheGoalWhileMoving) {
  Detail detail;
  detail.add(200, 1'000'000);
  const DrawOptions options = detail.options(true, 1'000'000);
  EXPECT_EQ(options.most_triangles, 250'000U);
  EXPECT_EQ(options.samples, 1);
}

TEST(Detail, DrawsEverythingWhileMovingOnAFastDevice) {
  Detail detail;
  detail.add(10, 1'000'000);
  EXPECT_EQ(detail.options(true, 1'000'000).most_triangles, DrawOptions::kAll);
}

TEST(Detail, NeverDrawsLessThanAUsefulCount) {
  Detail detail;
  detail.add(60'000, 1'000'000);
  EXPECT_EQ(detail.options(true, 1'000'000).most_triangles, Detail::kLeast);
}

TEST(Detail, LearnsNothingFromFramesOfFewTriangles) {
  Detail detail;
  detail.add(500, 12);
  EXPECT_EQ(detail.options(true, 1'000'000).most_triangles, DrawOptions::kAll);
}

}  // namespace
}  // namespace soms::view
