#include "bench/peers/scenarios/grazing.h"

namespace soms::bench {

std::optional<double> free_way(const std::function<bool(double way)>& touches,
                               const Search& search) {
  double free = 0;
  double touching = 0;
  while (!touches(touching)) {
    free = touching;
    touching += search.step;
    if (touching > search.reach) {
      return std::nullopt;
    }
  }
  if (touching == 0) {
    return std::nullopt;
  }
  while (touching - free > search.within) {
    const double middle = 0.5 * (free + touching);
    (touches(middle) ? touching : free) = middle;
  }
  return free;
}

Pose onward(const Pose& start, const Vec3& direction, double distance) {
  Pose pose = start;
  pose.m[3] += distance * direction.x;
  pose.m[7] += distance * direction.y;
  pose.m[11] += distance * direction.z;
  return pose;
}

}  // namespace soms::bench
