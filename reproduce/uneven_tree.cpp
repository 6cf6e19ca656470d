#include "reproduce/uneven_tree.h"

#include "soms/geometry/midpoint.h"

#include <algorithm>
#include <cstdint>
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

class UnevenBuilder {
 public:
  UnevenBuilder(const Mesh& mesh, double share) : mesh_(mesh), share_(share) {
    tree_.primitives.resize(mesh.triangles.size());
    std::iota(tree_.primitives.begin(), tree_.primitives.end(), TriangleId{0});
    for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
      midpoints_.push_back(midpoint(mesh.triangle(i), Midpoint::thesis, 2));
    }
  }

  Tree build() {
    if (!tree_.primitives.empty()) {
      const auto all = static_cast<std::uint32_t>(tree_.primitives.size());
      open_.push_back({0, all, 0, 0, Node::kNone, false});
    }
    while (!open_.empty()) {
      const Open next = open_.back();
      open_.pop_back();
      divide(next);
    }
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Box bounds(const Open& open) const {
    Box box;
    for (std::uint32_t i = open.first; i < open.first + open.count; ++i) {
      box.grow(soms::bounds(mesh_.triangle(tree_.primitives[i])));
    }
    return box;
  }

  /// Makes the node and leaves its children to be divided, the left one first.
  void divide(const Open& open) {
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
    if (open.count < 2) {
      return;
    }
    sort(open, tree_.nodes.back().bounds);
    const auto part = static_cast<std::uint32_t>(share_ * open.count);
    const std::uint32_t left = std::clamp<std::uint32_t>(part, 1, open.count - 1);
    const auto child_id = [&](TreeId (*of)(TreeId)) {
      return open.id == kNoTreeId ? kNoTreeId : of(open.id);
    };
    open_.push_back({open.first + left, open.count - left, open.depth + 1, child_id(right_child_of),
                     index, true});
    open_.push_back({open.first, left, open.depth + 1, child_id(left_child_of), index, false});
  }

  void sort(const Open& open, const Box& box) {
    const Vec3 extent = box.upper - box.lower;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      axis = extent[k] > extent[axis] ? k : axis;
    }
    const auto begin = tree_.primitives.begin() + open.first;
    std::sort(begin, begin + open.count, [&](TriangleId i, TriangleId j) {
      return std::pair(midpoints_[i][axis], i) < std::pair(midpoints_[j][axis], j);
    });
  }

  const Mesh& mesh_;
  double share_;
  Tree tree_;
  std::vector<Vec3> midpoints_;
  std::vector<Open> open_;
};

}  // namespace

Tree uneven_tree(const Mesh& mesh, double share) {
  return UnevenBuilder(mesh, share).build();
}

}  // namespace soms::reproduce
