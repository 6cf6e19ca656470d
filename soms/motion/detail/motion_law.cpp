#include "soms/motion/detail/motion_law.h"

#include "soms/base/error.h"

namespace soms::detail {

double MotionLaw::across(const Vec3& /*n*/) const {
  return 1;
}

const RigidMotion* MotionLaw::alone() const {
  return nullptr;
}

void MotionLaw::set_margins(double reach, double slack, double turn_margin) {
  if (!(reach <= kMaxCoordinate)) {
    throw Error(ErrorKind::out_of_range, "motion: the body may come beyond 2^300 on its way",
                "use a larger unit, or a pivot nearer to the body");
  }
  reach_ = reach;
  slack_ = slack;
  turn_margin_ = turn_margin;
}

}  // namespace soms::detail
