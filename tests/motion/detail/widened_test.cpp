#include "soms/motion/detail/widened.h"

#include "soms/base/pose.h"

#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soms::detail {

namespace {

Box flat(double lower, double upper) {
  return {{lower, lower, lower}, {upper, upper, upper}};
}

TEST(Widened, GrowsByTheMarginAndHardlyMore) {
  const Box wide = widened({{0, 1, 2}, {3, 5, 7}}, 0.5);
  EXPECT_TRUE(wide.contains({{-0.5, 0.5, 1.5}, {3.5, 5.5, 7.5}}));
  EXPECT_TRUE((Box{{-0.5001, 0.4999, 1.4999}, {3.5001, 5.5001, 7.5001}}.contains(wide)));
}

TEST(Widened, KeepsAnEmptyBoxEmpty) {
  EXPECT_TRUE(widened({}, 5).empty());
  EXPECT_TRUE(widened({}, std::numeric_limits<double>::max()).empty());
}

TEST(Widened, EndsWhereNoSurfaceIs) {
  const Box wide = widened(flat(-kMaxCoordinate, 1), std::numeric_limits<double>::max());
  EXPECT_EQ(wide, flat(-kMaxCoordinate, kMaxCoordinate));
}

// Each margin is the gap of two points, rounded up, so the boxes must meet however the sums round.
TEST(Widened, OfTwoBoxesWithinTheMarginMeet) {
  test::for_each_case("scene/widened", 20000, [](Rng& rng) {
    const double scale = std::pow(2.0, rng.uniform(-1074, 290));
    const double a = rng.uniform(-1, 1) * scale;
    const double b = rng.uniform(-1, 1) * scale * std::pow(2.0, rng.uniform(-60, 2));
    const double low = std::min(a, b);
    const double high = std::max(a, b);
    double margin = high - low;
    // The rounding error of the difference, exactly (Knuth's two-sum).
    const double back = margin - high;
    const double error = (high - (margin - back)) + (-low - back);
    if (error > 0) {
      margin = std::nextafter(margin, std::numeric_limits<double>::infinity());
    }
    ASSERT_TRUE(overlaps(widened(flat(low, low), margin), flat(high, high)));
    ASSERT_TRUE(overlaps(flat(low, low), widened(flat(high, high), margin)));
    ASSERT_TRUE(
        overlaps(widened(flat(low, low), margin / 2), widened(flat(high, high), margin / 2)));
  });
}

}  // namespace

}  // namespace soms::detail
