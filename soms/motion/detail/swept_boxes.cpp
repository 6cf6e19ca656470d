#include "soms/motion/detail/swept_boxes.h"

namespace soms::detail {

namespace {

/// Column i of a node's axes.
Vec3 axis_of(const WideNode& node, std::size_t i) {
  return {node.row[0][i], node.row[1][i], node.row[2][i]};
}

/// A lane, or the box of all of them, in the coordinates of the body.
struct LaneBox {
  Vec3 center;
  Vec3 half;

  LaneBox(const WideTree& tree, const WideNode& node, bool whole, std::size_t lane)
      : center(tree.origin() + Vec3{node.origin[0], node.origin[1], node.origin[2]}) {
    const double unit = 1 / tree.scale();
    const double more = kAxesShare * (node.l1_radius * unit);
    for (std::size_t i = 0; i < 3; ++i) {
      half[i] = (whole ? node.row[i][3] : node.half[i][lane]) * unit + more;
      if (!whole) {
        center += axis_of(node, i) * (node.center[i][lane] * unit);
      }
    }
  }

  [[nodiscard]] BoxSway sway(const MotionBounds& bounds, const MotionInterval& interval) const {
    const double radius = length_of(half) * (1 + kAxesShare);
    const double bow = interval.bow.of(bounds.law().arm(center) + radius);
    return {radius, bow, (bow + interval.turn * radius) * kMotionUp};
  }
};

void put_axes(const WideNode& node, const Pose& map, SweptBoxes& boxes) {
  for (std::size_t i = 0; i < 3; ++i) {
    boxes.axis[i] = turned(map, axis_of(node, i));
    boxes.direction[i] = direction_of(boxes.axis[i]);
  }
}

}  // namespace

double SweptBoxes::radius(std::size_t lane) const {
  return length_of(lane_of(half, lane));
}

SweptBoxes swept_boxes(const WideTree& tree, const WideNode& node, const MotionBounds& bounds,
                       const MotionInterval& interval, const BoxChoice& choice) {
  SweptBoxes boxes;
  boxes.count = choice.count;
  put_axes(node, interval.mean, boxes);
  for (std::size_t lane = 0; lane < boxes.count; ++lane) {
    const LaneBox box(tree, node, choice.whole, choice.first + lane);
    put_lane(mapped(interval.mean, box.center), lane, boxes.center);
    put_lane(mapped(interval.change, box.center), lane, boxes.change);
    put_lane(box.half, lane, boxes.half);
    const BoxSway sway = box.sway(bounds, interval);
    boxes.give[lane] = sway.give;
    boxes.bow[lane] = sway.bow;
  }
  return boxes;
}

SweptBoxes resting_boxes(const WideTree& tree, const WideNode& node, const Pose& pose,
                         const BoxChoice& choice) {
  SweptBoxes boxes;
  boxes.count = choice.count;
  put_axes(node, pose, boxes);
  for (std::size_t lane = 0; lane < boxes.count; ++lane) {
    const LaneBox box(tree, node, choice.whole, choice.first + lane);
    put_lane(mapped(pose, box.center), lane, boxes.center);
    put_lane(box.half, lane, boxes.half);
  }
  return boxes;
}

BoxSway sway_of_whole(const WideTree& tree, const WideNode& node, const MotionBounds& bounds,
                      const MotionInterval& interval) {
  return LaneBox(tree, node, true, 0).sway(bounds, interval);
}

double radius_of_whole(const WideTree& tree, const WideNode& node) {
  return length_of(LaneBox(tree, node, true, 0).half);
}

}  // namespace soms::detail
