/// \file
/// A stretch of the way of a motion, and the chord that stands for it.
#pragma once

#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/time_window.h"

#include <algorithm>
#include <cstdint>

namespace soms::detail {

/// Times [from, to], which are multiples of a power of two, and the chord of motion_bounds.h there.
struct MotionInterval {
  static constexpr std::uint32_t kNone = 0xffffffffU;

  MotionInterval(const MotionBounds& bounds, double begin, double end);

  /// No contact of a window is before this, in the time of the whole way.
  [[nodiscard]] double begin_of(const TimeWindow& window) const {
    return std::max(from, middle + half * std::max(-1.0, window.lower) - 0x1p-51);
  }

  /// Nor after this.
  [[nodiscard]] double end_of(const TimeWindow& window) const {
    return std::min(to, middle + half * std::min(1.0, window.upper) + 0x1p-51);
  }

  double from;
  double to;
  double middle;
  double half;
  Pose mean;                     ///< half the sum of the poses at both ends: a map, not a pose
  Pose change;                   ///< half their difference
  double turn;                   ///< no vector changes by more of its length
  Curvature bow;                 ///< no point leaves the chord by more than this of its arm
  std::uint32_t halves = kNone;  ///< the first half; the second follows
};

/// Where a map takes a point, and where it takes a vector.
[[nodiscard]] inline Vec3 turned(const Pose& map, const Vec3& v) {
  const auto& m = map.m;
  return {(m[0] * v.x + m[1] * v.y) + m[2] * v.z, (m[4] * v.x + m[5] * v.y) + m[6] * v.z,
          (m[8] * v.x + m[9] * v.y) + m[10] * v.z};
}

/// The difference of two vectors of a frame, as its axes see it.
[[nodiscard]] inline Vec3 turned_back(const Pose& pose, const Vec3& v) {
  const auto& m = pose.m;
  return {(m[0] * v.x + m[4] * v.y) + m[8] * v.z, (m[1] * v.x + m[5] * v.y) + m[9] * v.z,
          (m[2] * v.x + m[6] * v.y) + m[10] * v.z};
}

[[nodiscard]] inline Vec3 mapped(const Pose& map, const Vec3& v) {
  return turned(map, v) + map.shift();
}

/// A vector in the direction of `v`, of length 1 to 2^-50; zero for one that has no length, or
/// next to none beside the doubles.
[[nodiscard]] inline Vec3 direction_of(Vec3 v) {
  const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(most > 0x1p-1000)) {
    return {};
  }
  // Those that are short are first made longer.
  v = most > 0x1p-400 ? v : v * 0x1p600;
  return v * (1 / std::sqrt(dot(v, v)));
}

}  // namespace soms::detail
