#include "soms/scene/detail/larger_box.h"

#include <algorithm>
#include <cstring>

namespace soms::detail {

namespace {

/// A larger box grows by no more than this many boxes, and in a call, as far as is foretold.
constexpr float kMostGrowth = 2;
constexpr double kMostGrowthOfACall = 1e3;
/// Sides and ways above this, in widths of the set, do not count.
constexpr float kLongest = 1e30F;
/// Growth to all sides, as a part of the way ahead.
constexpr float kAside = 0.25F;
/// A box that moves less than this part of what boxes usually do gets that much room: floats may
/// show motion where there is hardly any.
constexpr float kLeastMotion = 1.0F / 32;

/// Motion of both ends of a box in one call.
struct Motion {
  lanes::F4 lower{};
  lanes::F4 upper{};
  float farthest = 0;
};

float greatest(lanes::F4 v) {
  return std::max({v[0], v[1], v[2]});
}

/// None where one of the boxes is empty.
Motion motion_of(const FloatBox& from, const FloatBox& to, float a_call) {
  if (!(from.lower[0] <= from.upper[0] && to.lower[0] <= to.upper[0])) {
    return {};
  }
  Motion motion;
  motion.lower = (load(to.lower) - load(from.lower)) * a_call;
  motion.upper = (load(to.upper) - load(from.upper)) * a_call;
  motion.farthest = greatest(
      lanes::max(lanes::max(motion.lower, -motion.lower), lanes::max(motion.upper, -motion.upper)));
  return motion;
}

/// 0 for a side beyond the range of floats, so that no sum of growth overflows.
lanes::F4 sides_of(const FloatBox& box) {
  const lanes::F4 sides = load(box.upper) - load(box.lower);
  return lanes::F4{sides[0] < kLongest ? sides[0] : 0, sides[1] < kLongest ? sides[1] : 0,
                   sides[2] < kLongest ? sides[2] : 0, 0};
}

/// The longest side, or 0 if one is beyond the range of floats or the box is empty.
float longest_side(const FloatBox& box) {
  const float side = greatest(load(box.upper) - load(box.lower));
  return side < kLongest ? side : 0;
}

/// `box` made larger for `calls` more calls of such ways and of `margin` to all sides, by at most
/// `most`.
FloatBox grown(const FloatBox& box, const Motion& motion, float calls, float margin, float most) {
  // A way beyond the range of floats is endless, and no call of it is no number: no growth.
  const lanes::F4 limit = lanes::splat(most);
  const auto bounded = [&](lanes::F4 sides) {
    return lanes::min(lanes::max(sides, lanes::F4{}), limit);
  };
  const float room = margin * calls > 0 ? std::min(margin * calls, most) : 0.0F;
  const lanes::F4 aside{room, room, room, 0};
  const lanes::F4 lower = load(box.lower) - (bounded(-motion.lower * calls) + aside);
  const lanes::F4 upper = load(box.upper) + (bounded(motion.upper * calls) + aside);
  FloatBox large;
  std::memcpy(large.lower, &lower, sizeof large.lower);
  std::memcpy(large.upper, &upper, sizeof large.upper);
  return large;
}

/// As `larger_box`, to all sides by `aside` of the way.
FloatBox enlarged(const FloatBox& from, const FloatBox& to, const Growth& growth, float a_call,
                  float aside) {
  const Motion motion = motion_of(from, to, a_call);
  const float margin = aside * std::max(motion.farthest, growth.usual.way * kLeastMotion);
  return grown(to, motion, static_cast<float>(growth.calls), margin,
               kMostGrowth * (growth.usual.side + longest_side(to)));
}

}  // namespace

UsualMotion usual_motion(std::span<const FloatBox> from, std::span<const FloatBox> to,
                         std::uint64_t calls) {
  const float a_call = 1 / static_cast<float>(calls);
  const bool known = from.size() == to.size();
  lanes::F4 sides{};
  lanes::F4 growth{};
  UsualMotion usual;
  for (std::size_t k = 0; k < to.size(); ++k) {
    usual.side += std::max(longest_side(to[k]), 0.0F);
    if (known) {
      const Motion motion = motion_of(from[k], to[k], a_call);
      const float farthest = motion.farthest < kLongest ? motion.farthest : 0;
      sides += lanes::max(sides_of(to[k]), lanes::F4{});
      growth +=
          lanes::min(lanes::max(-motion.lower, lanes::F4{}) + lanes::max(motion.upper, lanes::F4{}),
                     lanes::splat(kLongest)) +
          lanes::splat(2 * kAside * farthest);
      usual.way += farthest;
    }
  }
  const float count = std::max(1.0F, static_cast<float>(to.size()));
  usual.side /= count;
  usual.way /= count;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto side = static_cast<double>(sides[axis]);
    if (side > 0) {
      usual.growth[axis] = std::min(static_cast<double>(growth[axis]) / side, kMostGrowthOfACall);
    }
  }
  return usual;
}

FloatBox larger_box(const FloatBox& from, const FloatBox& to, const Growth& growth) {
  return enlarged(from, to, growth, 1 / static_cast<float>(growth.known_calls), 1);
}

void make_larger(std::span<const FloatBox> from, std::span<const FloatBox> to, const Growth& growth,
                 std::vector<FloatBox>& large) {
  const float a_call = 1 / static_cast<float>(growth.known_calls);
  large.resize(to.size());
  for (std::size_t k = 0; k < to.size(); ++k) {
    large[k] = enlarged(from[k], to[k], growth, a_call, kAside);
  }
}

}  // namespace soms::detail
