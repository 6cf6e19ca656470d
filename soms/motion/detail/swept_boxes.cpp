#include "soms/motion/detail/swept_boxes.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// Column i of a node's axes.
Vec3 axis_of(const WideNode& node, std::size_t i) {
  return {node.row[0][i], node.row[1][i], node.row[2][i]};
}

/// The center of a lane in the coordinates of the body, and half its sides.
Vec3 place_lane(const WideTree& tree, const WideNode& node, bool whole, std::size_t lane,
                std::array<double, 3>& half) {
  const double unit = 1 / tree.scale();
  Vec3 center = tree.origin() + Vec3{node.origin[0], node.origin[1], node.origin[2]};
  const double more = kAxesShare * (node.l1_radius * unit);
  for (std::size_t i = 0; i < 3; ++i) {
    half[i] = (whole ? node.row[i][3] : node.half[i][lane]) * unit + more;
    if (!whole) {
      center += axis_of(node, i) * (node.center[i][lane] * unit);
    }
  }
  return center;
}

double length_of_half(const std::array<double, 3>& half) {
  return length_of({half[0], half[1], half[2]});
}

void put_axes(const WideNode& node, const Pose& map, SweptBoxes& boxes) {
  for (std::size_t i = 0; i < 3; ++i) {
    boxes.axis[i] = turned(map, axis_of(node, i));
    boxes.direction[i] = direction_of(boxes.axis[i]);
  }
}

/// Projections of boxes on a direction of length 1.
struct Shadow {
  std::array<double, SweptBoxes::kLanes> center;
  std::array<double, SweptBoxes::kLanes> change;
  std::array<double, SweptBoxes::kLanes> radius;

  Shadow(const SweptBoxes& boxes, const Vec3& n) {
    std::array<double, 3> share{};
    for (std::size_t i = 0; i < 3; ++i) {
      share[i] = std::abs(dot(n, boxes.axis[i]));
    }
    for (std::size_t lane = 0; lane < boxes.count; ++lane) {
      const auto& half = boxes.half[lane];
      center[lane] = dot(n, boxes.center[lane]);
      change[lane] = dot(n, boxes.change[lane]);
      radius[lane] = (share[0] * half[0] + share[1] * half[1]) + share[2] * half[2];
    }
  }
};

/// `v` less what reaches it along the axes of a box.
Vec3 beyond(Vec3 v, const SweptBoxes& boxes, std::size_t lane) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = dot(v, boxes.direction[i]);
    const double half = boxes.half[lane][i];
    v = v - boxes.direction[i] * std::clamp(along, -half, half);
  }
  return v;
}

/// The way between the boxes of two lanes where their centers are nearest within the window.
Vec3 way_between(const SweptBoxes& x, std::size_t i, const SweptBoxes& y, std::size_t j,
                 const TimeWindow& window) {
  const Vec3 apart = y.center[j] - x.center[i];
  const Vec3 w = x.change[i];
  const double squared = dot(w, w);
  const double at = squared > 0 ? dot(apart, w) / squared : 0;
  const Vec3 way = apart - w * std::clamp(at, std::max(-1.0, window.lower),
                                          std::max(window.lower, window.upper));
  return direction_of(beyond(beyond(way, y, j), x, i));
}

/// Narrows one window along one direction.
void narrow_along(const Vec3& n, const SweptBoxes& x, std::size_t i, const SweptBoxes& y,
                  std::size_t j, double reach, TimeWindow& window) {
  double radius = reach;
  for (std::size_t k = 0; k < 3; ++k) {
    radius += std::abs(dot(n, x.axis[k])) * x.half[i][k];
    radius += std::abs(dot(n, y.axis[k])) * y.half[j][k];
  }
  window.narrow(dot(n, y.center[j]) - dot(n, x.center[i]), dot(n, x.change[i]), radius);
}

}  // namespace

double SweptBoxes::radius(std::size_t lane) const {
  return length_of_half(half[lane]);
}

SweptBoxes swept_boxes(const WideTree& tree, const WideNode& node, const MotionBounds& bounds,
                       const MotionInterval& interval, bool whole) {
  SweptBoxes boxes;
  boxes.count = whole ? 1 : node.count;
  put_axes(node, interval.mean, boxes);
  for (std::size_t lane = 0; lane < boxes.count; ++lane) {
    const Vec3 center = place_lane(tree, node, whole, lane, boxes.half[lane]);
    boxes.center[lane] = mapped(interval.mean, center);
    boxes.change[lane] = mapped(interval.change, center);
    const double radius = length_of_half(boxes.half[lane]) * (1 + kAxesShare);
    boxes.give[lane] =
        (interval.bow.of(bounds.law().arm(center) + radius) + interval.turn * radius) * kMotionUp;
  }
  return boxes;
}

SweptBoxes resting_boxes(const WideTree& tree, const WideNode& node, const Pose& pose, bool whole) {
  SweptBoxes boxes;
  boxes.count = whole ? 1 : node.count;
  put_axes(node, pose, boxes);
  for (std::size_t lane = 0; lane < boxes.count; ++lane) {
    boxes.center[lane] = mapped(pose, place_lane(tree, node, whole, lane, boxes.half[lane]));
    boxes.change[lane] = {};
    boxes.give[lane] = 0;
  }
  return boxes;
}

void find_windows(const SweptBoxes& x, const SweptBoxes& y, double margin, LaneWindows& windows) {
  windows.fill({});
  for (std::size_t k = 0; k < 6; ++k) {
    const Vec3& n = k < 3 ? y.direction[k] : x.direction[k - 3];
    const Shadow sx(x, n);
    const Shadow sy(y, n);
    for (std::size_t i = 0; i < x.count; ++i) {
      for (std::size_t j = 0; j < y.count; ++j) {
        windows[4 * i + j].narrow(sy.center[j] - sx.center[i], sx.change[i],
                                  (sx.radius[i] + sy.radius[j]) + (x.give[i] + margin));
      }
    }
  }
  for (std::size_t i = 0; i < x.count; ++i) {
    for (std::size_t j = 0; j < y.count; ++j) {
      TimeWindow& window = windows[4 * i + j];
      if (!window.empty()) {
        narrow_along(way_between(x, i, y, j, window), x, i, y, j, x.give[i] + margin, window);
      }
    }
  }
}

}  // namespace soms::detail
