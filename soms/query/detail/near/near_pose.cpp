#include "soms/query/detail/near/near_pose.h"

#include "soms/base/double_limits.h"
#include "soms/query/detail/engine/rounded.h"
#include "soms/query/detail/near/direction.h"
#include "soms/query/detail/near/far_support.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// Bodies are far apart from this many times their radii on.
constexpr double kFar = 32;

// Constants of the proof in near_pose.h. "Largest seen" is the most that tests and
// tests/query/margins/near_margin_search.cpp ever needed of one. What is left over was never met;
// that it cannot be is not claimed.

/// The stretch: by how much lengths seen in the axes of y differ. Largest seen: 0.75 of the first,
/// where R is off by as much in every entry, and of the second, with an inverse that is off so; no
/// answer needs the second, since `inverse_of` leaves a residual of a few u64, and none the third,
/// since floats are rounded by far more. Answers need neither beside kOffsetShare.
constexpr double kSkewShare = 2;
constexpr double kResidualShare = 4;
constexpr double kStretchRounding = 32 * kRoundingUnit;
static_assert(1.53 < kSkewShare && 3.1 < kResidualShare);
static_assert((1.53 * 4 + 3.1 * 3.01) * kRoundingUnit < kStretchRounding);

/// `relative` of the numbers is 2.75 m; keys may exceed a distance by 3.02 m of it. Largest seen,
/// of this, the numbers' margins and the stretch together: 0.054 for keys of nodes, 0.028 for
/// slabs.
constexpr double kOffsetShare = 1.5;
static_assert(kOffsetShare * 2.75 > 4);

/// The least `rounding` of the numbers, in units of the layout: what is left over of it covers what
/// squares of lengths lose that underflow. Only where a point is the reference is it less by
/// itself.
constexpr float kLeastRounding = 0x1p-70F;

/// Least values of `sign` times triangles' points along `w`.
std::array<float, TriangleBlock::kWidth> supports(const TriangleBlock& block,
                                                  const std::array<float, 3>& w, float sign) {
  std::array<float, TriangleBlock::kWidth> least = {};
  for (std::size_t k = 0; k < TriangleBlock::kWidth; ++k) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float here =
          sign * ((w[0] * block.corner[3 * corner][k] + w[1] * block.corner[3 * corner + 1][k]) +
                  w[2] * block.corner[3 * corner + 2][k]);
      least[k] = corner == 0 ? here : std::min(least[k], here);
    }
  }
  return least;
}

}  // namespace

double skew(const Matrix3& r) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = (r[0][i] * r[0][j] + r[1][i] * r[1][j]) + r[2][i] * r[2][j];
      most = std::max(most, std::abs(entry - (i == j ? 1 : 0)));
    }
  }
  return most;
}

NearPose::NearPose(PairFrame& frame)
    : x_(frame.x()),
      y_(frame.y()),
      stretch_(kSkewShare * skew(rotation(*y_.pose)) +
               kResidualShare * frame.relative().residual() + kStretchRounding) {
  frame.relative().prepare();
  numbers_ = frame.relative().numbers();
  numbers_.rounding = std::max(numbers_.rounding, kLeastRounding);
  scale_ = numbers_.scale;
  const WideTree& tree_x = x_.layout();
  const WideTree& tree_y = y_.layout();
  const Vec3 half_x = tree_x.bounds().extent() * 0.5;
  const Vec3 half_y = tree_y.bounds().extent() * 0.5;
  const double apart = length(place_of(x_, {}) - place_of(y_, {}));
  if (scale_ != 0 && apart > kFar * (length(half_x) + length(half_y))) {
    far_ = true;
    base_ = apart;
    const double extent =
        moved_extent(*x_.pose, tree_x.bounds()) + moved_extent(*y_.pose, tree_y.bounds());
    slack_ = (kFarRounding * extent + kFarUnderflow) * scale_ + 0x1p-100;
  }
  set_limit(std::numeric_limits<double>::infinity());
}

void NearPose::set_limit(double upper) {
  if (far_) {
    const double beyond = (upper - base_) * scale_;
    limit_ = static_cast<float>(beyond + (std::abs(beyond) * 0x1p-22 + 0x1p-100));
    return;
  }
  const double near = upper * (1 + stretch_) * scale_ * (1 + kOffsetShare * numbers_.relative);
  limit_ = rounded_up(near);
  numbers_.slack = rounded_up(static_cast<double>(numbers_.rounding) + near);
}

double NearPose::distance_of(float key) const {
  if (scale_ == 0) {
    return 0;
  }
  constexpr double kDown = 1 - 0x1p-40;
  if (far_) {
    const double beyond = static_cast<double>(key) / scale_;
    return std::max((base_ + beyond) * kDown, 0.0);
  }
  const double seen = static_cast<double>(key) / (1 + kOffsetShare * numbers_.relative);
  return std::max(seen / ((1 + stretch_) * scale_) * kDown, 0.0);
}

template <class X, class Y>
NearPose::Heading NearPose::heading(const X& x, const Y& y) const {
  const Vec3 way = place_of(x_, x.origin) - place_of(y_, y.origin);
  const Vec3 unit = direction(way);
  return {seen(*x_.pose, unit, axes_of(x)), seen(*y_.pose, unit, axes_of(y)),
          (dot(unit, way) / length(unit) - base_) * scale_,
          slack_ + kFarBoxes * (static_cast<double>(x.l1_radius) * numbers_.ratio + y.l1_radius)};
}

void NearPose::far_keys(const NodeTask& task, float limit, NodeKeys& keys) const {
  const Heading way = heading(*task.x, *task.y);
  const auto of_x = supports(*task.x, way.in_x, 1);
  const auto of_y = supports(*task.y, way.in_y, -1);
  keys.near = 0;
  for (std::size_t r = 0; r < WideNode::kWidth; ++r) {
    for (std::size_t k = 0; k < WideNode::kWidth; ++k) {
      const double sum = (way.between + static_cast<double>(of_x[k]) * numbers_.ratio) +
                         static_cast<double>(of_y[(k + r) % WideNode::kWidth]);
      const float key = rounded_down(sum - way.margin);
      keys.key[4 * r + k] = key;
      keys.near |= (key > limit ? 0U : 1U) << (4 * r + k);
    }
  }
  keys.near &= task.pairs;
}

void NearPose::far_keys(const TriangleBlock& x, const TriangleBlock& y, BlockKeys& keys) const {
  const Heading way = heading(x, y);
  const auto of_x = supports(x, way.in_x, 1);
  const auto of_y = supports(y, way.in_y, -1);
  for (std::size_t i = 0; i < TriangleBlock::kWidth; ++i) {
    for (std::size_t k = 0; k < TriangleBlock::kWidth; ++k) {
      const double sum = (way.between + static_cast<double>(of_x[i]) * numbers_.ratio) +
                         static_cast<double>(of_y[k]);
      keys[i][k] = rounded_down(sum - way.margin);
    }
  }
}

}  // namespace soms::detail
