#include "soms/motion/detail/motion_interval.h"

#include <cmath>
#include <cstddef>

namespace soms::detail {

MotionInterval::MotionInterval(const MotionBounds& bounds, double begin, double end)
    : from(begin), to(end), middle(begin + (end - begin) / 2), half((end - begin) / 2) {
  const MotionLaw& law = bounds.law();
  const Pose first = law.at(from);
  const Pose last = law.at(to);
  double squares = 0;
  for (std::size_t k = 0; k < 12; ++k) {
    mean.m[k] = first.m[k] / 2 + last.m[k] / 2;
    change.m[k] = last.m[k] / 2 - first.m[k] / 2;
    squares += k % 4 == 3 ? 0 : change.m[k] * change.m[k];
  }
  turn = std::sqrt(squares / 2) * kStretch + law.turn_margin();
  bow = MotionBounds::bow(law.curvature(from, to), to - from);
}

}  // namespace soms::detail
