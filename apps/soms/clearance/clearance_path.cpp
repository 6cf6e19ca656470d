#include "apps/soms/clearance/clearance_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms::command {

namespace {

/// The rotation that makes an axis +x: without rounding.
Pose rotation_of(Forward forward) {
  Pose pose;
  const double c = forward == Forward::x ? 1 : forward == Forward::minus_x ? -1 : 0;
  const double s = forward == Forward::y ? 1 : forward == Forward::minus_y ? -1 : 0;
  pose.m = {c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0};
  return pose;
}

/// Where a route places the origin of a model, at the start of a line or at its end.
Pose pose_on_line(const Vec3& from, const Vec3& to, bool at_end) {
  Route line{.points = {from, to}};
  line.start = at_end ? line.length() : 0;
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
  PointPath(const MoverRoute& route, const Vec3& foot, Forward forward)
      : points_(route.path.points), foot_(foot), rotation_(rotation_of(forward)) {}

  ProfilePath path() {
    for (std::size_t k = 1; k < points_.size(); ++k) {
      if (points_[k] != points_[k - 1]) {
        add_line(k);
      }
    }
    if (poses_.empty()) {
      add(pose_on_line(points_.front(), points_.front(), false), 0);
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
      add(pose_on_line(from, from + left, false), k - 1);
    }
    const Pose start = pose_on_line(from, points_[k], false);
    if (poses_.empty() || !turns_alike(poses_.back(), start * rotation_)) {
      add(start, k - 1);
    }
    add(pose_on_line(from, points_[k], true), k);
    last_direction_ = direction;
  }

  /// Puts the foot of the model where its origin would be.
  void add(const Pose& origin, std::size_t row) {
    Pose pose = origin * rotation_;
    for (std::size_t k = 0; k < 3; ++k) {
      const double* const r = &pose.m[4 * k];
      pose.m[4 * k + 3] -= (r[0] * foot_.x + r[1] * foot_.y) + r[2] * foot_.z;
    }
    poses_.push_back(pose);
    rows_.push_back(row);
  }

  const std::vector<Vec3>& points_;
  Vec3 foot_;
  Pose rotation_;
  Vec3 last_direction_;
  std::vector<Pose> poses_;
  std::vector<std::size_t> rows_;
};

}  // namespace

ProfilePath profile_path(const MoverRoute& route, const Vec3& foot, Forward forward) {
  if (route.recorded == nullptr) {
    return PointPath(route, foot, forward).path();
  }
  std::vector<Pose> poses = *route.recorded;
  for (Pose& pose : poses) {
    pose = forward == Forward::x ? pose : pose * rotation_of(forward);
  }
  ProfilePath path{.motion = motion_path(std::move(poses))};
  for (std::size_t k = 0; k < path.motion.poses.size(); ++k) {
    path.rows.push_back(k);
  }
  return path;
}

}  // namespace soms::command
