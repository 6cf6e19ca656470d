#include "apps/soms/clearance_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::command {

namespace {

/// The model at the start of a line, or at its end, as a route places it.
Pose pose_on_line(const Vec3& from, const Vec3& to, bool at_end, const Vec3& foot) {
  MoverRoute line;
  line.path.points = {from, to};
  line.path.start = at_end ? line.path.length() : 0;
  line.foot = foot;
  return line.at(0);
}

bool turns_alike(const Pose& a, const Pose& b) {
  for (std::size_t k = 0; k < 12; ++k) {
    if (k % 4 != 3 && a.m[k] != b.m[k]) {
      return false;
    }
  }
  return true;
}

/// True for lines whose ground plans lead back where they came from.
bool is_half_turn(const Vec3& from, const Vec3& to) {
  const double along = from.x * to.x + from.y * to.y;
  const double across = from.x * to.y - from.y * to.x;
  return along < 0 && std::abs(across) <= -1e-9 * along;
}

/// The lines of a route of points, with the poses between which it turns on the spot.
class PointPath {
 public:
  explicit PointPath(const MoverRoute& route) : points_(route.path.points), foot_(route.foot) {}

  ProfilePath path() {
    for (std::size_t k = 1; k < points_.size(); ++k) {
      if (points_[k] != points_[k - 1]) {
        add_line(k);
      }
    }
    if (poses_.empty()) {
      add(pose_on_line(points_.front(), points_.front(), false, foot_), 0);
    }
    return {motion_path(std::move(poses_), foot_), std::move(rows_)};
  }

 private:
  /// The line from the point before `k` to that.
  void add_line(std::size_t k) {
    const Vec3& from = points_[k - 1];
    const Vec3 direction = points_[k] - from;
    if (!poses_.empty() && is_half_turn(last_direction_, direction)) {
      const Vec3 left{-last_direction_.y, last_direction_.x, 0};
      add(pose_on_line(from, from + left, false, foot_), k - 1);
    }
    const Pose start = pose_on_line(from, points_[k], false, foot_);
    if (poses_.empty() || !turns_alike(poses_.back(), start)) {
      add(start, k - 1);
    }
    add(pose_on_line(from, points_[k], true, foot_), k);
    last_direction_ = direction;
  }

  void add(const Pose& pose, std::size_t row) {
    poses_.push_back(pose);
    rows_.push_back(row);
  }

  const std::vector<Vec3>& points_;
  Vec3 foot_;
  Vec3 last_direction_;
  std::vector<Pose> poses_;
  std::vector<std::size_t> rows_;
};

}  // namespace

ProfilePath profile_path(const MoverRoute& route) {
  if (route.recorded == nullptr) {
    return PointPath(route).path();
  }
  ProfilePath path{.motion = motion_path(*route.recorded)};
  for (std::size_t k = 0; k < path.motion.poses.size(); ++k) {
    path.rows.push_back(k);
  }
  return path;
}

}  // namespace soms::command
