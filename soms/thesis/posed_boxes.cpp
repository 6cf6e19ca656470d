#include "soms/thesis/posed_boxes.h"

#include "soms/base/arithmetic.h"

#include <cmath>
#include <limits>

namespace soms {

namespace {

bool only_shifts(const Pose& pose) {
  const Vec3 t = pose.shift();
  return pose == Pose::translation(t.x, t.y, t.z);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Corner of `box` where row `k` of the moved coordinates is least: each term is monotone, falling
/// where its factor is negative. The opposite corner has the greatest.
Vec3 least_corner(const Pose& pose, const Box& box, std::size_t k) {
  Vec3 corner;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    corner[axis] = pose.m[4 * k + axis] < 0 ? box.upper[axis] : box.lower[axis];
  }
  return corner;
}

Vec3 greatest_corner(const Pose& pose, const Box& box, std::size_t k) {
  Vec3 corner;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    corner[axis] = pose.m[4 * k + axis] < 0 ? box.lower[axis] : box.upper[axis];
  }
  return corner;
}

}  // namespace

PosedBoxes::PosedBoxes(const MeshView& mesh, const Tree& tree) : mesh_(mesh), tree_(&tree) {
}

void PosedBoxes::move(const Pose& pose, BoxUpdate update) {
  const PlainArithmetic plain;
  if (pose_ == pose && update_ == update) {
    return;
  }
  vertices_.resize(mesh_.vertices.size());
  boxes_.resize(tree_->nodes.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    vertices_[i] = pose.apply(mesh_.vertices[i]);
  }
  if (update == BoxUpdate::rebox) {
    rebox(pose);
  } else if (only_shifts(pose)) {
    shift(pose.shift());
  } else {
    refit();
  }
  pose_ = pose;
  update_ = update;
}

void PosedBoxes::shift(const Vec3& by) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const Box& box = tree_->nodes[i].bounds;
    boxes_[i] = {box.lower + by, box.upper + by};
  }
}

// Children come after their parents in the order of nodes, so backwards is leaves up.
void PosedBoxes::refit() {
  for (std::size_t i = boxes_.size(); i-- > 0;) {
    const Node& node = tree_->nodes[i];
    Box box;
    if (node.is_leaf()) {
      for (const TriangleId t : tree_->triangles_of(node)) {
        box.grow(bounds(triangle(t)));
      }
    } else {
      box.grow(boxes_[node.left]);
      box.grow(boxes_[node.right]);
    }
    boxes_[i] = box;
  }
}

void PosedBoxes::rebox(const Pose& pose) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const Box& box = tree_->nodes[i].bounds;
    boxes_[i] = Box{};
    for (std::size_t k = 0; k < 3 && !box.empty(); ++k) {
      boxes_[i].lower[k] = std::nextafter(pose.apply(least_corner(pose, box, k))[k], -kInfinity);
      boxes_[i].upper[k] = std::nextafter(pose.apply(greatest_corner(pose, box, k))[k], kInfinity);
    }
  }
}

}  // namespace soms
