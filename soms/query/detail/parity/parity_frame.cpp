#include "soms/query/detail/parity/parity_frame.h"

#include "soms/base/double_limits.h"
#include "soms/query/detail/relative_pose.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

// Constants of the proof in parity_frame.h.
constexpr double kWorldRounding = 64 * kRoundingUnit;
constexpr double kWorldUnderflow = 0x1p-1064;  // a length in the world
constexpr double kMostSlack = 0x1p50;
static_assert(25 + 18.1 + 4.01 < 64);

/// At least `x`, which is not negative.
float rounded_far_up(double x) {
  return static_cast<float>((x + 0x1p-100) * (1 + 0x1p-22));
}

}  // namespace

ParityFrame::ParityFrame(const WideTree& tree, const Pose& pose)
    : origin_(pose.apply(tree.origin())) {
  const Matrix3 r = rotation(pose);
  const double rounding = kWorldRounding * moved_extent(pose, tree.bounds()) + kWorldUnderflow;
  const Vec3 half = tree.bounds().extent() * 0.5;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side =
        (std::abs(r[k][0]) * half.x + std::abs(r[k][1]) * half.y) + std::abs(r[k][2]) * half.z;
    half_[k] = side + rounding;
  }
  std::size_t shortest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    shortest = half_[k] < half_[shortest] ? k : shortest;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (shortest + i) % 3;
    numbers_.axis[i] = static_cast<std::uint8_t>(k);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto entry = static_cast<float>(r[k][j]);
      numbers_.row[i][j] = entry;
      numbers_.exact[i][j] = r[k][j];
      numbers_.rotated = numbers_.rotated || r[k][j] != (j == k ? 1 : 0);
    }
  }
  const double slack = rounding * tree.scale();
  numbers_.scale = slack > kMostSlack ? 0 : tree.scale();
  numbers_.slack = rounded_far_up(std::min(slack, kMostSlack));
}

bool ParityFrame::outside(const Vec3& point) const {
  const Vec3 d = origin_ - point;
  return std::abs(d.x) > half_.x || std::abs(d.y) > half_.y || std::abs(d.z) > half_.z;
}

RayStart ParityFrame::start(const Vec3& point) const {
  const Vec3 d = origin_ - point;
  RayStart start;
  for (std::size_t i = 0; i < 3; ++i) {
    start.from[i] = d[numbers_.axis[i]];
  }
  start.sign = start.from[0] > 0 ? -1.0F : 1.0F;
  return start;
}

}  // namespace soms::detail
