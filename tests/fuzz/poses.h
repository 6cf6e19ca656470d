/// \file
/// Poses from a fuzzer's input.
#pragma once

#include "soms/base/pose.h"

#include "tests/fuzz/bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace soms::fuzz {

/// The identity, whole and fractional shifts of up to eight units, and these after any turn.
inline Pose pose_of(Bytes& bytes, double unit) {
  const std::uint32_t kind = bytes.below(4);
  if (kind == 0) {
    return {};
  }
  const double x = unit * (kind == 1 ? bytes.below(9) : 8 * bytes.fraction());
  const double y = unit * (kind == 1 ? bytes.below(9) : 8 * bytes.fraction());
  const Vec3 shift{x, y, unit * bytes.fraction()};
  if (kind < 3) {
    return Pose::translation(shift.x, shift.y, shift.z);
  }
  std::array<double, 4> q = {bytes.fraction(), bytes.fraction(), bytes.fraction(),
                             bytes.fraction()};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (length < 0x1p-20) {
    q = {1, 0, 0, 0};
  } else {
    std::for_each(q.begin(), q.end(), [&](double& part) { part /= length; });
  }
  return Pose::from_quaternion(q[0], q[1], q[2], q[3], shift);
}

}  // namespace soms::fuzz
