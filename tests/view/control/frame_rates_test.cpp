#include "apps/view/control/frame_rates.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

Facts frame_of(std::uint64_t frame, double collision_ms) {
  Facts facts;
  facts.frame = frame;
  facts.collision_ms = collision_ms;
  return facts;
}

TEST(FrameRates, AreMeansOfTheFramesThatMoved) {
  FrameRates rates;
  const ViewState state;
  rates.add(state, frame_of(0, 9), 900);  // builds trees
  EXPECT_EQ(rates.rates().frames, 0U);
  rates.add(state, frame_of(1, 1), 10);
  rates.add(state, frame_of(2, 3), 30);
  EXPECT_EQ(rates.rates().frames, 2U);
  EXPECT_EQ(rates.rates().collision_ms, 2);
  EXPECT_EQ(rates.rates().whole_ms, 20);
  EXPECT_TRUE(rates.rates().moving);
  rates.add(state, frame_of(2, 3), 500);  // a better picture of the same frame
  EXPECT_EQ(rates.rates().frames, 2U);
  EXPECT_EQ(rates.rates().whole_ms, 20);
  EXPECT_FALSE(rates.rates().moving);
}

TEST(FrameRates, CountWhatTheHandMoves) {
  FrameRates rates;
  const ViewState state;
  Facts facts = frame_of(0, 1);
  facts.object = Pose();
  rates.add(state, facts, 10);
  facts.object = Pose::translation(1, 0, 0);
  rates.add(state, facts, 12);
  EXPECT_EQ(rates.rates().frames, 1U);
  EXPECT_EQ(rates.rates().whole_ms, 12);
}

TEST(FrameRates, StartAnewWithAnotherTestTreeOrTraversal) {
  for (int what = 0; what < 3; ++what) {
    FrameRates rates;
    ViewState state;
    rates.add(state, frame_of(0, 1), 10);
    rates.add(state, frame_of(1, 1), 10);
    ASSERT_EQ(rates.rates().frames, 1U);
    if (what == 0) {
      state.orientation_test = 1;
    } else if (what == 1) {
      state.tree.per_leaf = 1;
    } else {
      state.traversal = Traversal::e_node;
    }
    rates.add(state, frame_of(2, 5), 500);
    EXPECT_EQ(rates.rates().frames, 0U) << what;
    rates.add(state, frame_of(3, 5), 20);
    EXPECT_EQ(rates.rates().collision_ms, 5) << what;
  }
}

TEST(FrameRates, ForgetWhatIsLongPast) {
  FrameRates rates;
  const ViewState state;
  rates.add(state, frame_of(0, 1), 10);
  for (std::size_t k = 1; k <= 2 * FrameRates::kKept; ++k) {
    rates.add(state, frame_of(k, k > FrameRates::kKept ? 2 : 1), 10);
  }
  EXPECT_EQ(rates.rates().frames, FrameRates::kKept);
  EXPECT_NEAR(rates.rates().collision_ms, 2, 1e-12);
}

TEST(FrameRates, AreSaidWithWhatTheyAre) {
  const Facts facts = frame_of(0, 0.5);
  const std::vector<RateRow> none = rate_rows({}, facts);
  ASSERT_EQ(none.size(), 2U);
  EXPECT_EQ(none[0].ms, "0.5 ms");
  EXPECT_EQ(none[0].fps, "2,000 FPS");
  EXPECT_EQ(none[1].fps, "-");
  EXPECT_EQ(rate_line({}), "this frame; nothing has moved yet");
  const Rates some{.frames = 49, .collision_ms = 0.25, .whole_ms = 16, .moving = true};
  const std::vector<RateRow> rows = rate_rows(some, facts);
  EXPECT_EQ(rows[0].ms, "0.25 ms");
  EXPECT_EQ(rows[0].fps, "4,000 FPS");
  EXPECT_EQ(rows[1].ms, "16 ms");
  EXPECT_EQ(rows[1].fps, "63 FPS");  // 62.5
  EXPECT_EQ(rate_line(some), "mean of the last 49 frames");
  Rates before = some;
  before.moving = false;
  EXPECT_EQ(rate_line(before), "at rest; mean of the last 49 frames");
  const Rates slow{.frames = 1, .collision_ms = 0, .whole_ms = 400, .moving = true};
  EXPECT_EQ(rate_rows(slow, facts)[1].fps, "2.5 FPS");
  EXPECT_EQ(rate_rows(slow, facts)[0].fps, "-");
  EXPECT_EQ(rate_line(slow), "mean of the last 1 frame");
}

}  // namespace
}  // namespace soms::view
