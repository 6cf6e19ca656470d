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

/// Least float not below `x`, for |x| < 2^127.
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

  [[nodiscard]] std::array<double, 3> middle(const Box& box) const {
    const Vec3 lower = box.lower - origin;
    const Vec3 upper = box.upper - origin;
    return {0.5 * (lower.x + upper.x), 0.5 * (lower.y + upper.y), 0.5 * (lower.z + upper.z)};
  }

  /// A point about a node's origin, in units of the layout.
  [[nodiscard]] Vec3 local(const Vec3& v, const std::array<double, 3>& node) const {
    return ((v - origin) - Vec3{node[0], node[1], node[2]}) * scale;
  }

  /// By how much a box of points about a node's origin gives way. A coordinate has seen two
  /// subtractions, u64 of the mesh's size (to the tree's origin) and u64 of itself (to the node's),
  /// a product with axes that adds 3 u64 of the 1-norm, and two sums more; 2^-130 is for what
  /// underflows. Turned axes Q are orthonormal to 2^-23 only, so what Q^T gives is off the
  /// coordinates a in Q a = v by 2^-23 of the 1-norm.
  [[nodiscard]] double doubt(const Box& box, bool turned) const {
    double norm = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      norm += std::max(std::abs(box.lower[k]), std::abs(box.upper[k]));
    }
    return (turned ? 0x1p-22 : 0x1p-49) * norm + 0x1p-50 * size + 0x1p-130;
  }
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
          node.child[k] = WideNode::kLeafBit | static_cast<std::uint32_t>(blocks_.size()) |
                          (below.count > TriangleBlock::kWidth ? WideNode::kRunBit : 0);
          node.leaves = static_cast<std::uint8_t>(node.leaves | 1U << k);
          add_leaf(below);
        } else {
          node.child[k] = static_cast<std::uint32_t>(nodes_.size());
          open.push_back({slots[k], node.child[k]});
          nodes_.emplace_back();
        }
      }
      if (std::max(nodes_.size(), blocks_.size()) >= WideNode::kMost) {
        throw Error(ErrorKind::out_of_range, "the layout has 2^28 nodes or blocks",
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

  using Lanes = std::array<Box, WideNode::kWidth>;

  /// Larger nodes keep the mesh's axes: what they hold is rarely flat, and looking costs O(n).
  static constexpr std::uint32_t kMostTurned = 512;
  static constexpr double kWorthTurning = 0.9;

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
                               std::uint32_t count) {
    const Node& whole = tree_.nodes[binary];
    WideNode wide;
    wide.count = static_cast<std::uint8_t>(count);
    wide.origin = frame_.middle(whole.bounds);
    Lanes lanes;
    for (std::size_t k = 0; k < count; ++k) {
      const Box& box = tree_.nodes[slots[k]].bounds;
      lanes[k] = {frame_.local(box.lower, wide.origin), frame_.local(box.upper, wide.origin)};
    }
    if (whole.count <= kMostTurned) {
      gather_corners(tree_.triangles_of(whole), wide.origin);
      const layout::Axes axes = layout::principal_axes(corners_);
      Lanes turned;
      for (std::size_t k = 0; k < count; ++k) {
        const Node& node = tree_.nodes[slots[k]];
        turned[k] = bounds_along(axes, node.first - whole.first, node.count);
      }
      if (total_area(turned) < kWorthTurning * total_area(lanes)) {
        lanes = turned;
        for (std::size_t k = 0; k < axes.size(); ++k) {
          wide.row[k / 3][k % 3] = axes[k];
        }
        wide.turned = 1;
      }
    }
    store(lanes, wide);
    return wide;
  }

  void store(const Lanes& lanes, WideNode& wide) const {
    double reach = 0;
    std::array<double, 3> own = {};
    for (std::size_t k = 0; k < wide.count; ++k) {
      const double give = frame_.doubt(lanes[k], wide.turned != 0);
      double distance = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double lower = lanes[k].lower[axis];
        const double upper = lanes[k].upper[axis];
        const auto center = static_cast<float>(0.5 * (lower + upper));
        wide.center[axis][k] = center;
        wide.half[axis][k] = rounded_up(std::max(upper - center, center - lower) + give);
        const double far = std::abs(center) + static_cast<double>(wide.half[axis][k]);
        own[axis] = std::max(own[axis], far);
        distance += far;
      }
      reach = std::max(reach, distance);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wide.row[axis][3] = rounded_up(own[axis]);
    }
    wide.reach = rounded_up(reach * (1 + 0x1p-50));  // the sum of three had two roundings
  }

  void add_leaf(const Node& leaf) {
    for (std::uint32_t done = 0; done < leaf.count; done += TriangleBlock::kWidth) {
      const std::uint32_t left = leaf.count - done;
      const std::uint32_t count = std::min(left, TriangleBlock::kWidth);
      blocks_.push_back(block_of(tree_.triangles_of(leaf).subspan(done, count)));
      blocks_.back().following = (left - 1) / TriangleBlock::kWidth & (WideNode::kMost - 1);
    }
  }

  [[nodiscard]] TriangleBlock block_of(std::span<const TriangleId> ids) {
    TriangleBlock block;
    block.count = static_cast<std::uint32_t>(ids.size()) & 0xf;
    Box whole;
    for (const TriangleId id : ids) {
      whole.grow(bounds(mesh_.triangle(id)));
    }
    block.origin = frame_.middle(whole);
    gather_corners(ids, block.origin);
    const Box box = bounds_along(layout::kMeshAxes, 0, static_cast<std::uint32_t>(ids.size()));
    const double give = frame_.doubt(box, false);
    double reach = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.own_half[axis] = rounded_up(std::max(-box.lower[axis], box.upper[axis]) + give);
      reach += static_cast<double>(block.own_half[axis]);
    }
    block.reach = rounded_up(reach * (1 + 0x1p-50));
    store_slab(give, block);
    for (std::size_t k = 0; k < TriangleBlock::kWidth; ++k) {
      const std::size_t from = std::min<std::size_t>(k, ids.size() - 1);
      block.id[k] = ids[from];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3& v = corners_[3 * from + corner];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          block.corner[3 * corner + axis][k] = static_cast<float>(v[axis]);
        }
      }
    }
    return block;
  }

  /// Mean normal of the gathered triangles, and their interval on it. Coordinates are in doubt by
  /// `give`, which is more than the products with the normal, of 1-norm below 1.74, can add.
  void store_slab(double give, TriangleBlock& block) const {
    Vec3 sum;
    for (std::size_t k = 0; k < corners_.size(); k += 3) {
      sum += cross(corners_[k + 1] - corners_[k], corners_[k + 2] - corners_[k]);
    }
    // Divided by its largest entry first, so that no square underflows.
    const double most = std::max({std::abs(sum.x), std::abs(sum.y), std::abs(sum.z)});
    const Vec3 n = most > 0 ? Vec3{sum.x / most, sum.y / most, sum.z / most} : Vec3{0, 0, 1};
    const double length = std::sqrt(dot(n, n));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.normal[axis] = static_cast<float>(n[axis] / length);
    }
    const Vec3 rounded{block.normal[0], block.normal[1], block.normal[2]};
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    for (const Vec3& v : corners_) {
      lower = std::min(lower, dot(rounded, v));
      upper = std::max(upper, dot(rounded, v));
    }
    block.lower = -rounded_up(3 * give - lower);
    block.upper = rounded_up(3 * give + upper);
  }

  /// Corners of triangles about an origin, three a triangle.
  void gather_corners(std::span<const TriangleId> ids, const std::array<double, 3>& origin) {
    corners_.clear();
    for (const TriangleId id : ids) {
      const Triangle t = mesh_.triangle(id);
      for (const Vec3* corner : {&t.a, &t.b, &t.c}) {
        corners_.push_back(frame_.local(*corner, origin));
      }
    }
  }

  /// Bounds along axes of `count` of the gathered triangles.
  [[nodiscard]] Box bounds_along(const layout::Axes& axes, std::uint32_t first,
                                 std::uint32_t count) const {
    Box box;
    for (const Vec3& v :
         std::span(corners_).subspan(std::size_t{3} * first, std::size_t{3} * count)) {
      box.grow(layout::along(axes, v));
    }
    return box;
  }

  static double total_area(const Lanes& lanes) {
    double sum = 0;
    for (const Box& box : lanes) {
      sum += half_area(box);
    }
    return sum;
  }

  const Tree& tree_;
  const Mesh& mesh_;
  const Frame& frame_;
  std::vector<WideNode>& nodes_;
  std::vector<TriangleBlock>& blocks_;
  std::vector<Vec3> corners_;
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
