#include "soms/scene/motion_path.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/scene/detail/motion_segment.h"

#include <cmath>
#include <string>
#include <utility>

namespace soms {

MotionPath motion_path(std::vector<Pose> poses, const Vec3& pivot) {
  const PlainArithmetic plain;
  MotionPath path{.poses = std::move(poses), .chainage = {}, .pivot = pivot};
  double sum = 0;
  for (std::size_t k = 0; k < path.poses.size(); ++k) {
    if (k > 0) {
      const Vec3 step = path.poses[k].apply(pivot) - path.poses[k - 1].apply(pivot);
      sum += std::sqrt(dot(step, step));
    }
    path.chainage.push_back(sum);
  }
  check(path);
  return path;
}

void check(const MotionPath& path) {
  const PlainArithmetic plain;
  if (path.poses.empty()) {
    throw Error(ErrorKind::usage, "path: no poses", "give at least one pose");
  }
  if (path.chainage.size() != path.poses.size()) {
    throw Error(ErrorKind::usage,
                "path: " + std::to_string(path.chainage.size()) + " chainages for " +
                    std::to_string(path.poses.size()) + " poses",
                "give one for each pose");
  }
  for (std::size_t k = 0; k < path.poses.size(); ++k) {
    try {
      check(path.poses[k]);
    } catch (const Error& error) {
      throw Error(error.kind(), "path: pose " + std::to_string(k) + ": " + error.place(),
                  error.remedy());
    }
    if (!std::isfinite(path.chainage[k]) || (k > 0 && path.chainage[k] < path.chainage[k - 1])) {
      throw Error(ErrorKind::usage,
                  "path: the chainage of pose " + std::to_string(k) +
                      " is not finite, or below that of the pose before",
                  "give finite numbers in ascending order");
    }
  }
}

Pose pose_at(const MotionPath& path, std::size_t segment, double t) {
  const PlainArithmetic plain;
  return detail::MotionSegment(path, segment, {{0, 0, 0}, {0, 0, 0}}).at(t).pose;
}

}  // namespace soms
