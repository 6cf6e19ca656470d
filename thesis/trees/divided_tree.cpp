#include "thesis/trees/divided_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace soms::reproduce {

namespace {

/// A node whose triangles wait to be divided.
struct Open {
  std::uint32_t first;
  std::uint32_t count;
  std::uint32_t depth;
  TreeId id;
  std::uint32_t parent;
  bool right;
};

class TreeDivider {
 public:
  TreeDivider(const MeshView& mesh, const DivideTriangles& divide, int level)
      : mesh_(mesh), divide_(divide), level_(level) {
    tree_.primitives.resize(mesh.triangles.size());
    std::iota(tree_.primitives.begin(), tree_.primitives.end(), TriangleId{0});
  }

  Tree build() {
    if (!tree_.primitives.empty()) {
      const auto all = static_cast<std::uint32_t>(tree_.primitives.size());
      open_.push_back({0, all, 0, 0, Node::kNone, false});
    }
    while (!open_.empty()) {
      const Open next = open_.back();
      open_.pop_back();
      make(next);
    }
    return std::move(tree_);
  }

 private:
  [[nodiscard]] std::span<TriangleId> triangles_of(const Open& open) {
    return std::span(tree_.primitives).subspan(open.first, open.count);
  }

  [[nodiscard]] Box bounds(const Open& open) {
    Box box;
    for (const TriangleId id : triangles_of(open)) {
      box.grow(soms::bounds(mesh_.triangle(id)));
    }
    return box;
  }

  [[nodiscard]] bool may_divide(const Open& open) const {
    return open.count > 1 && (level_ == 0 || open.depth + 1 < static_cast<std::uint32_t>(level_));
  }

  /// Makes the node and leaves its children to be divided, the left one first.
  void make(const Open& open) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.push_back({.bounds = bounds(open),
                           .id = open.id,
                           .first = open.first,
                           .count = open.count,
                           .depth = open.depth});
    if (open.parent != Node::kNone) {
      Node& parent = tree_.nodes[open.parent];
      (open.right ? parent.right : parent.left) = index;
    }
    if (!may_divide(open)) {
      return;
    }
    const std::uint32_t left = divide_(triangles_of(open), tree_.nodes.back().bounds);
    if (left == 0) {
      tree_.nodes.back().undividable = true;
      return;
    }
    const auto child_id = [&](TreeId (*of)(TreeId)) {
      return open.id == kNoTreeId ? kNoTreeId : of(open.id);
    };
    open_.push_back({open.first + left, open.count - left, open.depth + 1, child_id(right_child_of),
                     index, true});
    open_.push_back({open.first, left, open.depth + 1, child_id(left_child_of), index, false});
  }

  MeshView mesh_;
  const DivideTriangles& divide_;
  int level_;
  Tree tree_;
  std::vector<Open> open_;
};

}  // namespace

std::size_t longest_axis(const Box& box) {
  const Vec3 extent = box.extent();
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    axis = extent[k] > extent[axis] ? k : axis;
  }
  return axis;
}

Tree divided_tree(const MeshView& mesh, const DivideTriangles& divide, int level) {
  return TreeDivider(mesh, divide, level).build();
}

}  // namespace soms::reproduce
