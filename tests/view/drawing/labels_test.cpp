#include "apps/view/drawing/labels.h"

#include "apps/draw/stroke_font.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace soms::view {
namespace {

constexpr Size kLabelSize{400, 300};

Camera from_minus_y() {
  return {{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
}

std::vector<PlacedLabel> placed_in(const std::vector<Label>& labels) {
  return place_labels(labels, from_minus_y(), kLabelSize);
}

/// Distance of a label's box from the line through two pixels; negative where the line crosses it.
double clearance(const PlacedLabel& label, PixelPoint a, PixelPoint b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  std::array<double, 4> off{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double x = (k & 1U) != 0 ? label.upper_left.x : label.lower_right.x;
    const double y = (k & 2U) != 0 ? label.upper_left.y : label.lower_right.y;
    off[k] = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / length;
  }
  const auto [low, high] = std::minmax_element(off.begin(), off.end());
  return std::max(*low, -*high);
}

TEST(Labels, StandBesideTheMiddleOfTheirSegmentInAnyDirection) {
  for (int turn = 0; turn < 36; ++turn) {
    const double angle = turn * 0.1745;
    const Vec3 half{1.5 * std::cos(angle), 0, 1.5 * std::sin(angle)};
    const Label label{.a = half * -1.0, .b = half, .text = "0.1234"};
    const auto placed = placed_in({label});
    ASSERT_EQ(placed.size(), 1U);
    const PixelPoint a = project(from_minus_y(), kLabelSize, label.a)->pixel;
    const PixelPoint b = project(from_minus_y(), kLabelSize, label.b)->pixel;
    EXPECT_NEAR(clearance(placed[0], a, b), 9, 1e-6) << "turned by " << angle;
    const PixelPoint middle{(placed[0].upper_left.x + placed[0].lower_right.x) / 2,
                            (placed[0].upper_left.y + placed[0].lower_right.y) / 2};
    EXPECT_LT(std::hypot(middle.x - 200, middle.y - 150), look::width_of("0.1234", 13)) << angle;
    EXPECT_NEAR(placed[0].lower_right.x - placed[0].upper_left.x, look::width_of("0.1234", 13),
                1e-9);
    EXPECT_NEAR(placed[0].lower_right.y - placed[0].upper_left.y, 13, 1e-9);
  }
}

TEST(Labels, StandAboveASegmentThatIsOnePixel) {
  const auto placed = placed_in({{.a = {0, 0, 0}, .b = {1e-9, 0, 0}, .text = "5"}});
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_LT(placed[0].lower_right.y, 150);
}

TEST(Labels, FollowThePartOfTheirSegmentThatIsSeen) {
  // From the middle of the picture far out on the right, and behind the eye.
  const auto placed = placed_in({{.a = {0, 0, 0}, .b = {1e4, 0, 0}, .text = "10000"},
                                 {.a = {0, 0, -2}, .b = {1, -500, -2}, .text = "500"}});
  ASSERT_EQ(placed.size(), 2U);
  for (const PlacedLabel& label : placed) {
    EXPECT_GT(label.upper_left.x, 0);
    EXPECT_LT(label.lower_right.x, 400);
    EXPECT_GT(label.upper_left.y, 0);
    EXPECT_LT(label.lower_right.y, 300);
  }
  EXPECT_GT(placed[0].upper_left.x, 250) << "the middle of the seen half";
}

TEST(Labels, AreLeftOutWhereTheirSegmentIsNotSeen) {
  EXPECT_TRUE(placed_in({{.a = {0, -20, 0}, .b = {1, -30, 0}, .text = "1"}}).empty()) << "behind";
  EXPECT_TRUE(placed_in({{.a = {50, 0, 0}, .b = {60, 0, 0}, .text = "1"}}).empty()) << "beside";
  EXPECT_TRUE(placed_in({{.a = {50, 0, 0}, .b = {0, 0, 50}, .text = "1"}}).empty()) << "corner";
  EXPECT_TRUE(place_labels({}, from_minus_y(), kLabelSize).empty());
}

TEST(Labels, OfThoseThatCoverEachOtherTheFirstIsWritten) {
  const Label one{.a = {-1, 0, 0}, .b = {1, 0, 0}, .text = "1.5"};
  Label near = one;
  near.a.z = near.b.z = 0.1;
  Label far = one;
  far.a.z = far.b.z = -2;
  const auto placed = placed_in({one, near, far});
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_EQ(placed[0].label, 0U);
  EXPECT_EQ(placed[1].label, 2U);
}

TEST(Labels, StayInThePictureNearItsEdge) {
  const auto placed = placed_in({{.a = {-1, 0, 4.1}, .b = {1, 0, 4.1}, .text = "1.5"}});
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_GE(placed[0].upper_left.y, 6);
}

}  // namespace
}  // namespace soms::view
