#include "soms/query/detail/near/point_pose.h"

#include "soms/base/double_limits.h"
#include "soms/query/detail/engine/rounded.h"
#include "soms/query/detail/near/direction.h"
#include "soms/query/detail/near/far_support.h"
#include "soms/query/detail/near/near_pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

/// Points are far from this many times the body's radius on.
constexpr double kFarPoint = 16;

// Constants of the proof in point_pose.h.

constexpr double kPointRounding = 96;
constexpr double kOfResidual = 12;
constexpr double kPoseUnderflow = 0x1p-1064;
constexpr double kRowAtPoint = 1.74;
static_assert(4.01 * kRowAtPoint + (4.01 + 1.01 + 3.01) * kRowAtPoint + 32 + 2 * 3.5 + 10 <
              kPointRounding);
static_assert(10.5 < kOfResidual);

constexpr double kPointSkewShare = 2;
constexpr double kPointResidualShare = 4;
constexpr double kPointStretchRounding = 32 * kRoundingUnit;
static_assert(1.53 < kPointSkewShare && 3.1 < kPointResidualShare);
static_assert((1.53 * 4 + 3.1 * 3.01) * kRoundingUnit < kPointStretchRounding);

static_assert(1.74 + 3.01 * 1.74 + 4 + 3 < 64);  // kPointMargin, in units of 2^-24
static_assert(3 + 3.02 < 16);                    // kPointError

/// Where rounding outweighs the body this many times, every box is near.
constexpr double kMostPointSlack = 0x1p40;

}  // namespace

PointFrame::PointFrame(const Body& body)
    : body_{&body.shape, &body.pose},
      reference_(body_.layout(), body.pose),
      stretch_(kPointSkewShare * skew(rotation(body.pose)) +
               kPointResidualShare * reference_.residual + kPointStretchRounding),
      radius_(length(body_.layout().bounds().extent() * 0.5)) {
}

PointPose::PointPose(const PointFrame& frame, const Vec3& point) : frame_(&frame), point_(point) {
  const ReferenceFrame& reference = frame.reference();
  const WideTree& tree = *reference.tree;
  const Vec3 way = point - reference.origin;
  numbers_.place = {way.x, way.y, way.z};
  for (std::size_t i = 0; reference.rotated && i < 3; ++i) {
    const auto& row = reference.inverse[i];
    numbers_.place[i] = (row[0] * way.x + row[1] * way.y) + row[2] * way.z;
  }
  const double extent = reference.extent + largest(point);
  const double slack =
      2 *
      ((kPointRounding * kRoundingUnit + kOfResidual * reference.residual) * extent +
       kPoseUnderflow) *
      tree.scale();
  if (slack <= kMostPointSlack) {
    numbers_.scale = tree.scale();
    numbers_.slack = rounded_up(slack);
  } else {
    numbers_.scale = 0;
    numbers_.slack = 0x1p100F;
  }
  const double apart = length(way);
  if (numbers_.scale != 0 && apart > kFarPoint * frame.radius()) {
    far_ = true;
    base_ = apart;
    slack_ = (kFarRounding * extent + kPoseUnderflow) * numbers_.scale + 0x1p-100;
  }
}

void PointPose::set_limit(double upper) {
  if (numbers_.scale == 0) {
    return;
  }
  limit_ = rounded_up(far_ ? (upper - base_) * numbers_.scale
                           : upper * (1 + frame_->stretch()) * numbers_.scale);
}

double PointPose::distance_of(float key) const {
  if (numbers_.scale == 0) {
    return 0;
  }
  constexpr double kDown = 1 - 0x1p-40;
  const double seen = static_cast<double>(key) / numbers_.scale;
  const double in_world = far_ ? base_ + seen : seen / (1 + frame_->stretch());
  return std::max(in_world * kDown, 0.0);
}

template <class Y>
PointPose::Heading PointPose::heading(const Y& y) const {
  const PosedShape& body = frame_->body();
  const Vec3 way = point_ - place_of(body, y.origin);
  const Vec3 unit = direction(way);
  return {seen_in_doubles(*body.pose, unit, axes_of(y)),
          (dot(unit, way) / length(unit) - base_) * numbers_.scale,
          slack_ + kFarBoxes * static_cast<double>(y.l1_radius)};
}

void PointPose::far_keys(const WideNode& node, PointNodeKeys& keys) const {
  const Heading way = heading(node);
  for (std::size_t k = 0; k < WideNode::kWidth; ++k) {
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      most += way.along[axis] * static_cast<double>(node.center[axis][k]) +
              std::abs(way.along[axis]) * static_cast<double>(node.half[axis][k]);
    }
    keys.key[k] = rounded_down((way.between - most) - way.margin);
  }
}

void PointPose::far_keys(const TriangleBlock& block, PointBlockKeys& keys) const {
  const Heading way = heading(block);
  for (std::size_t k = 0; k < TriangleBlock::kWidth; ++k) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      double here = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        here += way.along[axis] * static_cast<double>(block.corner[3 * corner + axis][k]);
      }
      most = std::max(most, here);
    }
    keys.key[k] = rounded_down((way.between - most) - way.margin);
    keys.estimate[k] = keys.key[k];
  }
}

}  // namespace soms::detail
