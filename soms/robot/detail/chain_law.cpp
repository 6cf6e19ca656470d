#include "soms/robot/detail/chain_law.h"

#include "soms/motion/detail/motion_interval.h"
#include "soms/motion/detail/rigid_law.h"
#include "soms/query/detail/relative_pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

constexpr double kMeasured = 4;
constexpr double kSeenFromLink = 0x1p-42;
constexpr double kSeenTurn = 0x1p-44;

static_assert(kSeenFromLink >= 4 * 420 * kMotionUnit, "an inverse and a product, four times");
static_assert(kSeenTurn >= 4 * 118 * kMotionUnit, "their matrices, four times");

double farthest_corner(const Box& body) {
  return length_of(farthest(body)) * kMotionUp;
}

/// How far poses of a link put a point from the law that is no farther than `size` from its origin
/// and, with that, from the root.
double slack_of_link(const StateMotion::Reach& reach, double size) {
  return (reach.turn * size + reach.off_shift + reach.joints * kTinySlack) * reach.stretch;
}

/// What the matrix of a link may be off a rotation by; values turn it, no more.
double off_rotation(const StateMotion::Reach& reach) {
  return reach.turn + reach.off;
}

}  // namespace

ChainLaw::ChainLaw(const StateMotion& motion, std::uint32_t link, const Box& body,
                   const Pose& resting)
    : motion_(&motion),
      link_(link),
      resting_(resting),
      steps_(motion.chains().between(motion.chains().kinematics().root(), link)) {
  const StateMotion::Reach& reach = motion.reach(link);
  const double size = (reach.length + farthest_corner(body)) * reach.stretch;
  set_margins(2 * size, slack_of_link(reach, size), 2 * off_rotation(reach));
  bound_curvature();
}

ChainLaw::ChainLaw(const StateMotion& motion, std::uint32_t link, const Box& body,
                   std::uint32_t other, const Box& body_of_other)
    : motion_(&motion), link_(link), other_(other), steps_(motion.chains().between(other, link)) {
  const StateMotion::Reach& a = motion.reach(link);
  const StateMotion::Reach& b = motion.reach(other);
  const double stretch = a.stretch * b.stretch;
  const double size =
      2 * stretch *
      ((a.length + farthest_corner(body)) + (b.length + farthest_corner(body_of_other)));
  const double slack = (slack_of_link(a, size) + slack_of_link(b, size)) + kSeenFromLink * size;
  set_margins(2 * size, slack * stretch, 2 * (off_rotation(a) + off_rotation(b) + kSeenTurn));
  bound_curvature();
}

void ChainLaw::bound_curvature() {
  const std::vector<Joint>& joints = motion_->chains().kinematics().joints();
  double turning = 0;  // of all joints before
  double stretch = other_ ? 1 : motion_->chains().base_lengths().stretch;
  std::vector<double> weights;
  for (const ChainStep& step : steps_) {
    const double rate = std::abs(motion_->rate(step.joint));
    const bool turns_it = turns(joints[step.joint]);
    weights.push_back(rate * ((turns_it ? rate : 0) + 2 * turning));
    turning += turns_it ? rate : 0;
    rests_ = rests_ && rate == 0;
    stretch *= motion_->chains().lengths(step.joint).stretch + kLengthMargin;
  }
  double length = 0;  // from the joint to the origin of the link
  double speed = 0;   // of the origin, seen from the joint
  for (std::size_t k = steps_.size(); k-- > 0;) {
    const std::uint32_t joint = steps_[k].joint;
    const double offset = motion_->chains().lengths(joint).shift;
    const double rate = std::abs(motion_->rate(joint));
    length += steps_[k].up ? offset : 0;
    if (rate != 0 && turns(joints[joint])) {
      const double apart = (distance_half_way(joint) + speed / 2) * (stretch * kMotionUp);
      const double reach = std::min(length, apart);
      curvature_.all += weights[k] * reach;
      curvature_.by_arm += weights[k];
      speed += rate * reach;
    } else {
      curvature_.all += weights[k];
      speed += rate;
    }
    length += motion_->extension(joint) + (steps_[k].up ? 0 : offset);
  }
  curvature_ = curvature_ * stretch;
}

double ChainLaw::distance_half_way(std::uint32_t joint) const {
  const Joint& turning = motion_->chains().kinematics().joints()[joint];
  const Pose axis = motion_->pose(turning.child, 0.5);
  const Vec3 origin = motion_->pose(link_, 0.5).shift();
  const double apart =
      length_of(cross(turned(axis, direction_of(turning.axis)), origin - axis.shift()));
  const double stretch =
      motion_->reach(link_).stretch * (other_ ? motion_->reach(*other_).stretch : 1);
  return (apart * kMotionUp + kMeasured * slack()) * (stretch * stretch);
}

Pose ChainLaw::at(double t) const {
  const Pose pose = mover_at(t);
  return other_ ? frame_at(t).inverse() * pose : pose;
}

Pose ChainLaw::frame_at(double t) const {
  return other_ ? motion_->pose(*other_, t) : Pose();
}

Curvature ChainLaw::curvature(double /*ta*/, double /*tb*/) const {
  return curvature_;
}

double ChainLaw::arm(const Vec3& point) const {
  return length_of(point) * kMotionUp;
}

Twist ChainLaw::twist_at(double t) const {
  const std::vector<Joint>& joints = motion_->chains().kinematics().joints();
  const Vec3 pivot = mover_at(t).shift();
  Vec3 drift;
  Vec3 spin;
  for (const ChainStep& step : steps_) {
    const Joint& joint = joints[step.joint];
    const double rate = step.up ? -motion_->rate(step.joint) : motion_->rate(step.joint);
    if (rate == 0) {
      continue;
    }
    // The joint leaves its axis, and a joint that turns the origin of its child, where they are.
    const Pose child = motion_->pose(joint.child, t);
    const Vec3 along = turned(child, direction_of(joint.axis)) * rate;
    if (turns(joint)) {
      spin += along;
      drift += cross(along, pivot - child.shift());
    } else {
      drift += along;
    }
  }
  const Pose frame = frame_at(t);
  return {turned_back(frame, drift), turned_back(frame, spin),
          turned_back(frame, pivot - frame.shift())};
}

}  // namespace soms::detail
