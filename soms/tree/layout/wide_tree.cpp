#include "soms/tree/layout/wide_tree.h"

#include "soms/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms {

namespace {

// Floats hold sizes between these without loss, and a thousandfold product of them.
constexpr double kLeastUsualSize = 0x1p-30;
constexpr double kMostUsualSize = 0x1p60;
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

/// Turns binary nodes into wide ones, the root first, without recursion.
class Widener {
 public:
  Widener(const Tree& tree, const Vec3& origin, double scale, double size,
          std::vector<WideNode>& nodes, std::vector<WideLeaf>& leaves)
      : tree_(tree), origin_(origin), scale_(scale), size_(size), nodes_(nodes), leaves_(leaves) {}

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
          node.child[k] = WideNode::kLeafBit | static_cast<std::uint32_t>(leaves_.size());
          leaves_.push_back({below.first, below.count});
        } else {
          node.child[k] = static_cast<std::uint32_t>(nodes_.size());
          open.push_back({slots[k], node.child[k]});
          nodes_.emplace_back();
        }
      }
      if (nodes_.size() >= kMostNodes) {
        throw Error(ErrorKind::out_of_range, "the tree has more than 2^29 wide nodes",
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

  static constexpr std::size_t kMostNodes = std::size_t{1} << 29;

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
    const Box& whole = tree_.nodes[binary].bounds;
    std::array<double, WideNode::kWidth> reach = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wide.origin[axis] =
          0.5 * ((whole.lower[axis] - origin_[axis]) + (whole.upper[axis] - origin_[axis]));
      double own = 0;
      for (std::size_t k = 0; k < count; ++k) {
        const Box& box = tree_.nodes[slots[k]].bounds;
        // Errors of two subtractions a side: u64 of the mesh's size (relative to the tree's
        // origin), u64 of |lower| (to the node's); the two below add u64 of each again. 2^-50
        // covers them, and 2^-130 what underflows.
        const double lower = ((box.lower[axis] - origin_[axis]) - wide.origin[axis]) * scale_;
        const double upper = ((box.upper[axis] - origin_[axis]) - wide.origin[axis]) * scale_;
        const auto center = static_cast<float>(0.5 * (lower + upper));
        const double half = std::max(upper - center, center - lower) +
                            0x1p-50 * (std::abs(lower) + std::abs(upper)) + 0x1p-51 * size_ +
                            0x1p-130;
        wide.center[axis][k] = center;
        wide.half[axis][k] = rounded_up(half);
        const double far = std::abs(center) + static_cast<double>(wide.half[axis][k]);
        own = std::max(own, far);
        reach[k] += far;
      }
      wide.own_half[axis] = rounded_up(own);
    }
    // The 1-norm below is a sum of three doubles with at most two roundings.
    wide.reach = rounded_up(*std::max_element(reach.begin(), reach.end()) * (1 + 0x1p-50));
    return wide;
  }

  const Tree& tree_;
  Vec3 origin_;
  double scale_;
  double size_;  // of the whole mesh, in units of the layout
  std::vector<WideNode>& nodes_;
  std::vector<WideLeaf>& leaves_;
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
  primitives_ = tree.primitives;
  Widener(tree, origin_, scale_, size * scale_, nodes_, leaves_).run();
  nodes_.shrink_to_fit();
  leaves_.shrink_to_fit();
}

std::size_t WideTree::memory() const {
  return sizeof *this + nodes_.capacity() * sizeof(WideNode) +
         leaves_.capacity() * sizeof(WideLeaf) + primitives_.capacity() * sizeof(TriangleId);
}

}  // namespace soms
