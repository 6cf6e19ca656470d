#include "soms/tree/layout/wide_tree.h"

#include "soms/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms {

namespace {

// Between these, products of five lengths neither overflow a float nor lose what matters in it.
constexpr double kLeastUsualSize = 0x1p-20;
constexpr double kMostUsualSize = 0x1p20;
constexpr int kMostExponent = 1000;  // 2^1000 is a double, and 2^300 times 2^-1000 is too

int exponent_for(double size) {
  if (size == 0 || (size >= kLeastUsualSize && size <= kMostUsualSize)) {
    return 0;
  }
  return std::min(kMostExponent, -std::ilogb(size));
}

/// Least float not below `x`, for 0 <= x < 2^127.
float rounded_up(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) >= x ? f
                                     : std::nextafter(f, std::numeric_limits<float>::infinity());
}

/// Place and unit that the floats of a layout are relative to.
struct Frame {
  Vec3 origin;
  double scale;
  double size;  // longest side of the mesh's box, in units of the layout

  [[nodiscard]] double middle(const Box& box, std::size_t axis) const {
    return 0.5 * ((box.lower[axis] - origin[axis]) + (box.upper[axis] - origin[axis]));
  }

  /// Covers the rounding that a number of magnitude `x` has seen on its way here: two subtractions,
  /// u64 of the mesh's size (to the tree's origin) and u64 of itself (to the node's), then two sums
  /// more; and 2^-130 for what underflows.
  [[nodiscard]] double doubt(double x) const { return 0x1p-50 * x + 0x1p-51 * size + 0x1p-130; }
};

/// Turns binary nodes into wide ones, the root first, without recursion.
class Widener {
 public:
  Widener(const Tree& tree, const Mesh& mesh, const Frame& frame, std::vector<WideNode>& nodes,
          std::vector<TriangleBlock>& blocks)
      : tree_(tree), mesh_(mesh), frame_(frame), nodes_(nodes), blocks_(blocks) {}

  void run() {
    std::vector<Open> open;
    nodes_.emplace_back();
    open.push_back({0, 0});
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      std::array<std::uint32_t, WideNode::kWidth> slots = {};
      const std::uint32_t count = gather(next.binary, slots);
      WideNode node = boxes(next.binary, slots, count);
      for (std::uint32_t k = 0; k < count; ++k) {
        const Node& below = tree_.nodes[slots[k]];
        if (below.is_leaf()) {
          node.child[k] = WideNode::kLeafBit | static_cast<std::uint32_t>(blocks_.size());
          add_leaf(below);
        } else {
          node.child[k] = static_cast<std::uint32_t>(nodes_.size());
          open.push_back({slots[k], node.child[k]});
          nodes_.emplace_back();
        }
      }
      if (std::max(nodes_.size(), blocks_.size()) >= WideNode::kLeafBit) {
        throw Error(ErrorKind::out_of_range, "the layout has 2^31 nodes or blocks",
                    "allow more triangles in a leaf");
      }
      nodes_[next.wide] = node;
    }
  }

 private:
  struct Open {
    std::uint32_t binary;
    std::uint32_t wide;
  };

  /// The node that stands for `i`: nodes with one child that holds triangles are passed over.
  [[nodiscard]] std::uint32_t without_empty(std::uint32_t i) const {
    while (!tree_.nodes[i].is_leaf()) {
      const Node& node = tree_.nodes[i];
      if (tree_.nodes[node.left].count == 0) {
        i = node.right;
      } else if (tree_.nodes[node.right].count == 0) {
        i = node.left;
      } else {
        break;
      }
    }
    return i;
  }

  /// Opens the inner node of greatest area until there are four; returns how many there are.
  std::uint32_t gather(std::uint32_t binary,
                       std::array<std::uint32_t, WideNode::kWidth>& slots) const {
    slots[0] = without_empty(binary);
    std::uint32_t count = 1;
    while (count < WideNode::kWidth) {
      std::uint32_t best = count;
      double best_area = -1;
      for (std::uint32_t k = 0; k < count; ++k) {
        const Node& node = tree_.nodes[slots[k]];
        const double area = half_area(node.bounds);
        if (!node.is_leaf() && area > best_area) {
          best = k;
          best_area = area;
        }
      }
      if (best == count) {
        break;
      }
      const Node& opened = tree_.nodes[slots[best]];
      slots[best] = without_empty(opened.left);
      slots[count] = without_empty(opened.right);
      ++count;
    }
    return count;
  }

  [[nodiscard]] WideNode boxes(std::uint32_t binary,
                               const std::array<std::uint32_t, WideNode::kWidth>& slots,
                               std::uint32_t count) const {
    WideNode wide;
    wide.count = count;
    std::array<double, WideNode::kWidth> reach = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wide.origin[axis] = frame_.middle(tree_.nodes[binary].bounds, axis);
      double own = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const Box& box = tree_.nodes[slots[k]].bounds;
        const double lower = local(box.lower, wide.origin, axis);
        const double upper = local(box.upper, wide.origin, axis);
        const auto center = static_cast<float>(0.5 * (lower + upper));
        const double half = std::max(upper - center, center - lower) +
                            frame_.doubt(std::abs(lower) + std::abs(upper));
        wide.center[axis][k] = center;
        wide.half[axis][k] = rounded_up(half);
        const double far = std::abs(center) + static_cast<double>(wide.half[axis][k]);
        own = std::max(own, far);
        reach[k] += far;
      }
      wide.own_half[axis] = rounded_up(own);
    }
    // The 1-norm is a sum of three doubles with two roundings.
    wide.reach = rounded_up(*std::max_element(reach.begin(), reach.end()) * (1 + 0x1p-50));
    return wide;
  }

  void add_leaf(const Node& leaf) {
    for (std::uint32_t done = 0; done < leaf.count; done += TriangleBlock::kWidth) {
      const std::uint32_t left = leaf.count - done;
      TriangleBlock block;
      block.count = std::min(left, TriangleBlock::kWidth);
      block.following = (left - 1) / TriangleBlock::kWidth;
      fill(tree_.triangles_of(leaf).subspan(done, block.count), block);
      blocks_.push_back(block);
    }
  }

  void fill(std::span<const TriangleId> ids, TriangleBlock& block) const {
    Box box;
    for (const TriangleId id : ids) {
      box.grow(bounds(mesh_.triangle(id)));
    }
    double reach = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.origin[axis] = frame_.middle(box, axis);
      double own = 0;
      for (std::size_t k = 0; k < TriangleBlock::kWidth; ++k) {
        block.id[k] = ids[std::min<std::size_t>(k, ids.size() - 1)];
        const Triangle t = mesh_.triangle(block.id[k]);
        std::size_t row = axis;
        for (const Vec3* corner : {&t.a, &t.b, &t.c}) {
          const double x = local(*corner, block.origin, axis);
          block.corner[row][k] = static_cast<float>(x);
          own = std::max(own, std::abs(x) + frame_.doubt(std::abs(x)));
          row += 3;
        }
      }
      block.own_half[axis] = rounded_up(own);
      reach += static_cast<double>(block.own_half[axis]);
    }
    block.reach = rounded_up(reach * (1 + 0x1p-50));
  }

  /// A coordinate about a node's origin, in units of the layout.
  [[nodiscard]] double local(const Vec3& v, const std::array<double, 3>& origin,
                             std::size_t axis) const {
    return ((v[axis] - frame_.origin[axis]) - origin[axis]) * frame_.scale;
  }

  const Tree& tree_;
  const Mesh& mesh_;
  const Frame& frame_;
  std::vector<WideNode>& nodes_;
  std::vector<TriangleBlock>& blocks_;
};

}  // namespace

WideTree::WideTree(const Tree& tree, const Mesh& mesh) {
  if (mesh.triangles.empty()) {
    return;
  }
  bounds_ = tree.nodes.front().bounds;
  origin_ = bounds_.center();
  const Vec3 extent = bounds_.extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  exponent_ = exponent_for(size);
  scale_ = std::ldexp(1.0, exponent_);
  Widener(tree, mesh, {origin_, scale_, size * scale_}, nodes_, blocks_).run();
  nodes_.shrink_to_fit();
  blocks_.shrink_to_fit();
}

std::size_t WideTree::memory() const {
  return sizeof *this + nodes_.capacity() * sizeof(WideNode) +
         blocks_.capacity() * sizeof(TriangleBlock);
}

}  // namespace soms
