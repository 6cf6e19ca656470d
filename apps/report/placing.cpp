#include "apps/report/placing.h"

#include "soms/geometry/common_points.h"

#include <algorithm>
#include <cmath>

namespace soms::report {

double length(const Vec3& v) {
  return std::hypot(v.x, v.y, v.z);
}

Box moved(const Box& box, const Pose& pose) {
  Box all;
  for (unsigned corner = 0; corner < 8 && !box.empty(); ++corner) {
    all.grow(pose.apply({(corner & 1U) != 0 ? box.upper.x : box.lower.x,
                         (corner & 2U) != 0 ? box.upper.y : box.lower.y,
                         (corner & 4U) != 0 ? box.upper.z : box.lower.z}));
  }
  return all;
}

Vec3 moved_back(const Vec3& at, const Pose& pose) {
  const auto& m = pose.m;
  const Vec3 v = at - pose.shift();
  return {m[0] * v.x + m[4] * v.y + m[8] * v.z, m[1] * v.x + m[5] * v.y + m[9] * v.z,
          m[2] * v.x + m[6] * v.y + m[10] * v.z};
}

Triangle moved(const Triangle& t, const Pose& pose) {
  return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
}

std::array<Vec3, 2> crossing_line(const Triangle& a, const Triangle& b) {
  const CommonPoints common = common_points(a, b);
  if (common.empty()) {
    return {bounds(a).center(), bounds(b).center()};
  }
  std::array<Vec3, 2> line{common.corners[0], common.corners[0]};
  for (const Vec3& from : common.points()) {
    for (const Vec3& to : common.points()) {
      if (length(to - from) > length(line[1] - line[0])) {
        line = {from, to};
      }
    }
  }
  return line;
}

std::array<double, 4> quaternion(const Pose& pose) {
  const auto at = [&](std::size_t row, std::size_t column) { return pose.m[4 * row + column]; };
  const double trace = at(0, 0) + at(1, 1) + at(2, 2);
  const std::array<double, 4> most{at(0, 0), at(1, 1), at(2, 2), trace};
  const auto largest =
      static_cast<std::size_t>(std::max_element(most.begin(), most.end()) - most.begin());
  std::array<double, 4> q{};
  if (largest == 3) {
    q = {at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1), 1 + trace};
  } else {
    const std::size_t i = largest;
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    q[i] = 1 + at(i, i) - at(j, j) - at(k, k);
    q[j] = at(j, i) + at(i, j);
    q[k] = at(k, i) + at(i, k);
    q[3] = at(k, j) - at(j, k);
  }
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) {
    part /= norm;
  }
  return q;
}

}  // namespace soms::report
