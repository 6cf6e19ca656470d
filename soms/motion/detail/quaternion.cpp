#include "soms/motion/detail/quaternion.h"

#include <algorithm>

namespace soms::detail {

double length_of_small(const Vec3& v) {
  const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(most > 0)) {
    return 0;
  }
  const Vec3 u{v.x / most, v.y / most, v.z / most};
  return most * std::sqrt(dot(u, u));
}

Quaternion quaternion_of(const Pose& pose) {
  const auto& m = pose.m;
  const double xx = m[0];
  const double yy = m[5];
  const double zz = m[10];
  // Four times a component and the others, whichever is the largest: none is lost to cancellation.
  if (xx + yy + zz > 0) {
    return of_length_one({1 + xx + yy + zz, m[9] - m[6], m[2] - m[8], m[4] - m[1]});
  }
  if (xx >= yy && xx >= zz) {
    return of_length_one({m[9] - m[6], 1 + xx - yy - zz, m[1] + m[4], m[2] + m[8]});
  }
  if (yy >= zz) {
    return of_length_one({m[2] - m[8], m[1] + m[4], 1 + yy - xx - zz, m[6] + m[9]});
  }
  return of_length_one({m[4] - m[1], m[2] + m[8], m[6] + m[9], 1 + zz - xx - yy});
}

}  // namespace soms::detail
