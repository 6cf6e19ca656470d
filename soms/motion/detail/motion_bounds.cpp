#include "soms/motion/detail/motion_bounds.h"

#include "soms/query/detail/relative_pose.h"

namespace soms::detail {

MotionBounds::MotionBounds(const MotionLaw& law, const Shape& other, double clearance)
    : law_(&law), clearance_(clearance) {
  const double size = law.reach() + moved_extent(law.resting_pose(), other.bounds()) + clearance;
  const double slack = law.slack();
  box_margin_ = (clearance + (2 * slack + kBoxShare * size)) * kMotionUp + kTinyMargin;
  rounding_ = (2 * slack + kPairShare * size) + kTinyMargin;
  pair_margin_ = clearance + rounding_;
}

}  // namespace soms::detail
