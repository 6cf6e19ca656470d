#include "soms/tree/layout/detail/lay_out.h"

#include "soms/tree/build/detail/build_lanes.h"
#include "soms/tree/layout/detail/block.h"

#include <limits>

namespace soms::layout {

namespace {

using lanes::F4;

/// Larger nodes keep the mesh's axes: what they hold is rarely flat.
constexpr std::uint32_t kMostOriented = 512;

/// Boxes along other axes are taken where they have less than this share of the area.
constexpr double kWorthTurning = 0.9;

/// Bounds of points in float, four at a time, and the farthest 1-norm that went into them.
struct Bounds {
  std::array<F4, 3> lower;
  std::array<F4, 3> upper;
  double norm = 0;

  Bounds() {
    lower.fill(lanes::splat(std::numeric_limits<float>::infinity()));
    upper.fill(lanes::splat(-std::numeric_limits<float>::infinity()));
  }

  [[nodiscard]] Box box() const {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const F4 low = lower[axis];
      const F4 high = upper[axis];
      box.lower[axis] = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
      box.upper[axis] = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
    }
    return box;
  }
};

/// A node's own axes and place, from which blocks are seen.
struct View {
  Axes axes;
  std::array<double, 3> origin;
  double scale;

  /// The block's place seen from here, along the mesh's axes.
  [[nodiscard]] Vec3 offset(const std::array<double, 3>& place) const {
    return Vec3{place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]} * scale;
  }

  /// Bounds a block's corners along the axes, in float: of the terms that a coordinate is the sum
  /// of, at most `norm` together, none is off by more than 5 * 2^-24 of itself and of what is added
  /// to it (its corner's rounding, its product's, three sums'), 2^-22 more for the axes' defect.
  void bound(const TriangleBlock& block, Bounds& bounds) const {
    const Vec3 place = along(axes, offset(block.origin));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const F4 x = lanes::splat(axes[axis]);
      const F4 y = lanes::splat(axes[3 + axis]);
      const F4 z = lanes::splat(axes[6 + axis]);
      const F4 at = lanes::splat(static_cast<float>(place[axis]));
      F4 lower = bounds.lower[axis];
      F4 upper = bounds.upper[axis];
      for (std::size_t c = 0; c < 9; c += 3) {
        for (std::size_t k = 0; k < TriangleBlock::kWidth; k += 4) {
          const F4 v =
              ((x * lanes::load(&block.corner[c][k]) + y * lanes::load(&block.corner[c + 1][k])) +
               z * lanes::load(&block.corner[c + 2][k])) +
              at;
          lower = lanes::min(lower, v);
          upper = lanes::max(upper, v);
        }
      }
      bounds.lower[axis] = lower;
      bounds.upper[axis] = upper;
    }
    bounds.norm = std::max(bounds.norm, std::abs(place.x) + std::abs(place.y) + std::abs(place.z) +
                                            static_cast<double>(block.l1_radius));
  }
};

/// Lays out one part, children before parents.
class Writer {
 public:
  Writer(const Part& part, const PartPlan& plan, std::span<const TriangleId> primitives,
         const Mesh& mesh, const Frame& frame, std::span<WideNode> nodes,
         std::span<TriangleBlock> blocks)
      : part_(part),
        plan_(plan),
        primitives_(primitives),
        mesh_(mesh),
        frame_(frame),
        nodes_(nodes),
        blocks_(blocks),
        node_moments_(nodes.size()) {}

  void run() {
    if (plan_.nodes.empty()) {
      static_cast<void>(write_leaf(part_.nodes[plan_.root], 0, {}));
    }
    for (std::size_t i = plan_.nodes.size(); i-- > 0;) {
      fetch(i);
      nodes_[i] = make_node(i);
    }
  }

 private:
  /// Asks for what the leaves of nodes that come soon are made of.
  void fetch(std::size_t i) {
    constexpr std::size_t kIndicesAhead = 4;
    constexpr std::size_t kCornersAhead = 2;
    if (i >= kIndicesAhead) {
      for_each_triangle(i - kIndicesAhead,
                        [&](TriangleId id) { __builtin_prefetch(&mesh_.triangles[id]); });
    }
    if (i >= kCornersAhead) {
      for_each_triangle(i - kCornersAhead, [&](TriangleId id) {
        for (const std::uint32_t corner : mesh_.triangles[id]) {
          __builtin_prefetch(&mesh_.vertices[corner]);
        }
      });
    }
  }

  /// Triangles of a wide node's own leaves, of no more than a few blocks each.
  template <class Body>
  void for_each_triangle(std::size_t i, const Body& body) {
    const WidePlan& plan = plan_.nodes[i];
    for (std::size_t k = 0; k < plan.count; ++k) {
      const Node& below = part_.nodes[plan.slots[k]];
      if (below.is_leaf()) {
        const std::uint32_t count = std::min(below.count, 2 * TriangleBlock::kWidth);
        for (const TriangleId id : primitives_.subspan(below.first, count)) {
          body(id);
        }
      }
    }
  }

  /// Returns the moments of the leaf's triangles as seen from a place in units of the layout.
  Moments write_leaf(const Node& leaf, std::uint32_t block, const View& view) {
    Moments moments;
    for (std::uint32_t done = 0; done < leaf.count; done += TriangleBlock::kWidth, ++block) {
      const std::uint32_t left = leaf.count - done;
      const auto ids =
          primitives_.subspan(leaf.first + done, std::min(left, TriangleBlock::kWidth));
      const Moments own = make_block(mesh_, ids, frame_, blocks_[block]);
      moments.add(own, view.offset(blocks_[block].origin));
      blocks_[block].following = (left - 1) / TriangleBlock::kWidth & (WideNode::kMost - 1);
    }
    return moments;
  }

  [[nodiscard]] WideNode make_node(std::size_t i) {
    const WidePlan& plan = plan_.nodes[i];
    const Node& whole = part_.nodes[plan.binary];
    WideNode node;
    node.count = static_cast<std::uint8_t>(plan.count);
    node.origin = frame_.middle(whole.bounds);
    const View view{kMeshAxes, node.origin, frame_.scale};
    Moments& moments = node_moments_[i];
    Lanes plain;
    for (std::size_t k = 0; k < plan.count; ++k) {
      const Node& below = part_.nodes[plan.slots[k]];
      plain.box[k] = {frame_.local(below.bounds.lower, node.origin),
                      frame_.local(below.bounds.upper, node.origin)};
      plain.give[k] = frame_.doubt(norm_of(plain.box[k]), false);
      if (below.is_leaf()) {
        set_leaf(node, static_cast<std::uint32_t>(k), plan_.block_base + plan.child[k],
                 below.count);
        moments.add(write_leaf(below, plan.child[k], view), {});
      } else {
        node.child[k] = plan_.node_base + plan.child[k];
        moments.add(node_moments_[plan.child[k]], view.offset(nodes_[plan.child[k]].origin));
      }
    }
    if (whole.count <= kMostOriented) {
      turn_if_smaller(i, plain, node);
    }
    store(plain, node);
    return node;
  }

  void turn_if_smaller(std::size_t i, Lanes& plain, WideNode& node) {
    const WidePlan& plan = plan_.nodes[i];
    const View view{axes_of(node_moments_[i]), node.origin, frame_.scale};
    if (view.axes == kMeshAxes) {
      return;
    }
    Lanes oriented;
    double before = 0;
    double after = 0;
    for (std::size_t k = 0; k < plan.count; ++k) {
      Bounds bounds;
      for (std::uint32_t b = first_of_lane(plan, k); b < end_of_lane(plan, k); ++b) {
        view.bound(blocks_[b], bounds);
      }
      oriented.box[k] = bounds.box();
      oriented.give[k] = frame_.doubt(norm_of(oriented.box[k]), true) + 0x1p-18 * bounds.norm;
      before += half_area(plain.box[k]);
      after += half_area(oriented.box[k]);
    }
    if (after < kWorthTurning * before) {
      plain = oriented;
      for (std::size_t k = 0; k < view.axes.size(); ++k) {
        node.row[k / 3][k % 3] = view.axes[k];
      }
      node.oriented = 1;
    }
  }

  [[nodiscard]] std::uint32_t first_of_lane(const WidePlan& plan, std::size_t k) const {
    const Node& below = part_.nodes[plan.slots[k]];
    return below.is_leaf() ? plan.child[k] : plan_.nodes[plan.child[k]].first_block;
  }

  [[nodiscard]] std::uint32_t end_of_lane(const WidePlan& plan, std::size_t k) const {
    const Node& below = part_.nodes[plan.slots[k]];
    return below.is_leaf() ? plan.child[k] + blocks_[plan.child[k]].following + 1
                           : plan_.nodes[plan.child[k]].end_block;
  }

  const Part& part_;
  const PartPlan& plan_;
  std::span<const TriangleId> primitives_;
  const Mesh& mesh_;
  const Frame& frame_;
  std::span<WideNode> nodes_;
  std::span<TriangleBlock> blocks_;
  std::vector<Moments> node_moments_;  ///< about the nodes' origins
};

}  // namespace

void store(const Lanes& lanes, WideNode& node) {
  double l1_radius = 0;
  std::array<double, 3> own = {};
  for (std::size_t k = 0; k < node.count; ++k) {
    double distance = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double lower = lanes.box[k].lower[axis];
      const double upper = lanes.box[k].upper[axis];
      const auto center = static_cast<float>(0.5 * (lower + upper));
      node.center[axis][k] = center;
      node.half[axis][k] = rounded_up(std::max(upper - center, center - lower) + lanes.give[k]);
      const double far = std::abs(center) + static_cast<double>(node.half[axis][k]);
      own[axis] = std::max(own[axis], far);
      distance += far;
    }
    l1_radius = std::max(l1_radius, distance);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.row[axis][3] = rounded_up(own[axis]);
  }
  node.l1_radius = rounded_up(l1_radius * (1 + 0x1p-50));  // the sum of three had two roundings
}

void store_upper(const Box& whole, std::span<const Box> boxes, const Frame& frame, WideNode& node) {
  node.origin = frame.middle(whole);
  Lanes lanes;
  for (std::size_t k = 0; k < node.count; ++k) {
    lanes.box[k] = {frame.local(boxes[k].lower, node.origin),
                    frame.local(boxes[k].upper, node.origin)};
    lanes.give[k] = frame.doubt(norm_of(lanes.box[k]), false);
  }
  store(lanes, node);
}

void lay_out(const Part& part, const PartPlan& plan, std::span<const TriangleId> primitives,
             const Mesh& mesh, const Frame& frame, std::span<WideNode> nodes,
             std::span<TriangleBlock> blocks) {
  Writer(part, plan, primitives, mesh, frame, nodes, blocks).run();
}

}  // namespace soms::layout
