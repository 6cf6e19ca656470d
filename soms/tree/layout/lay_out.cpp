#include "soms/tree/layout/lay_out.h"

#include "soms/tree/layout/block.h"

namespace soms::layout {

namespace {

/// Larger nodes keep the mesh's axes: what they hold is rarely flat.
constexpr std::uint32_t kMostTurned = 512;

/// Boxes along other axes are taken where they have less than this share of the area.
constexpr double kWorthTurning = 0.9;

constexpr std::size_t kLanes = TriangleBlock::kWidth;

using FloatRow = std::array<float, kLanes>;

/// Bounds of points in float, eight at a time, and the farthest 1-norm that went into them.
struct Bounds {
  std::array<FloatRow, 3> lower;
  std::array<FloatRow, 3> upper;
  double norm = 0;

  Bounds() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis].fill(std::numeric_limits<float>::infinity());
      upper[axis].fill(-std::numeric_limits<float>::infinity());
    }
  }

  [[nodiscard]] Box box() const {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = *std::min_element(lower[axis].begin(), lower[axis].end());
      box.upper[axis] = *std::max_element(upper[axis].begin(), upper[axis].end());
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
      const float x = axes[axis];
      const float y = axes[3 + axis];
      const float z = axes[6 + axis];
      const auto at = static_cast<float>(place[axis]);
      FloatRow& lower = bounds.lower[axis];
      FloatRow& upper = bounds.upper[axis];
      for (std::size_t c = 0; c < 9; c += 3) {
        for (std::size_t k = 0; k < kLanes; ++k) {
          const float v =
              ((x * block.corner[c][k] + y * block.corner[c + 1][k]) + z * block.corner[c + 2][k]) +
              at;
          lower[k] = v < lower[k] ? v : lower[k];
          upper[k] = v > upper[k] ? v : upper[k];
        }
      }
    }
    bounds.norm = std::max(bounds.norm, std::abs(place.x) + std::abs(place.y) + std::abs(place.z) +
                                            static_cast<double>(block.reach));
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
        block_moments_(blocks.size()),
        node_moments_(nodes.size()) {}

  void run() {
    if (plan_.nodes.empty()) {
      write_leaf(part_.nodes[plan_.root], 0);
      return;
    }
    for (const WidePlan& wide : plan_.nodes) {
      for (std::uint32_t k = 0; k < wide.count; ++k) {
        const Node& below = part_.nodes[wide.slots[k]];
        if (below.is_leaf()) {
          write_leaf(below, wide.child[k]);
        }
      }
    }
    for (std::size_t i = plan_.nodes.size(); i-- > 0;) {
      nodes_[i] = make_node(i);
    }
  }

 private:
  void write_leaf(const Node& leaf, std::uint32_t block) {
    for (std::uint32_t done = 0; done < leaf.count; done += TriangleBlock::kWidth, ++block) {
      const std::uint32_t left = leaf.count - done;
      const auto ids =
          primitives_.subspan(leaf.first + done, std::min(left, TriangleBlock::kWidth));
      block_moments_[block] = make_block(mesh_, ids, frame_, blocks_[block]);
      blocks_[block].following = (left - 1) / TriangleBlock::kWidth & (WideNode::kMost - 1);
    }
  }

  [[nodiscard]] WideNode make_node(std::size_t i) {
    const WidePlan& plan = plan_.nodes[i];
    const Node& whole = part_.nodes[plan.binary];
    WideNode node;
    node.count = static_cast<std::uint8_t>(plan.count);
    node.origin = frame_.middle(whole.bounds);
    Lanes lanes;
    for (std::size_t k = 0; k < plan.count; ++k) {
      const Node& below = part_.nodes[plan.slots[k]];
      lanes.box[k] = {frame_.local(below.bounds.lower, node.origin),
                      frame_.local(below.bounds.upper, node.origin)};
      lanes.give[k] = frame_.doubt(norm_of(lanes.box[k]), false);
      if (below.is_leaf()) {
        set_leaf(node, static_cast<std::uint32_t>(k), plan_.block_base + plan.child[k],
                 below.count);
      } else {
        node.child[k] = plan_.node_base + plan.child[k];
      }
    }
    if (whole.count <= kMostTurned) {
      turn_if_smaller(i, lanes, node);
    }
    store(lanes, node);
    return node;
  }

  void turn_if_smaller(std::size_t i, Lanes& lanes, WideNode& node) {
    const WidePlan& plan = plan_.nodes[i];
    View view{kMeshAxes, node.origin, frame_.scale};
    Moments& moments = node_moments_[i];
    for (std::size_t k = 0; k < plan.count; ++k) {
      const Node& below = part_.nodes[plan.slots[k]];
      if (below.is_leaf()) {
        for (std::uint32_t b = plan.child[k]; b < end_of_lane(plan, k); ++b) {
          moments.add(block_moments_[b], view.offset(blocks_[b].origin));
        }
      } else {
        moments.add(node_moments_[plan.child[k]], view.offset(nodes_[plan.child[k]].origin));
      }
    }
    view.axes = axes_of(moments);
    if (view.axes == kMeshAxes) {
      return;
    }
    Lanes turned;
    double before = 0;
    double after = 0;
    for (std::size_t k = 0; k < plan.count; ++k) {
      Bounds bounds;
      for (std::uint32_t b = first_of_lane(plan, k); b < end_of_lane(plan, k); ++b) {
        view.bound(blocks_[b], bounds);
      }
      turned.box[k] = bounds.box();
      turned.give[k] = frame_.doubt(norm_of(turned.box[k]), true) + 0x1p-18 * bounds.norm;
      before += half_area(lanes.box[k]);
      after += half_area(turned.box[k]);
    }
    if (after < kWorthTurning * before) {
      lanes = turned;
      for (std::size_t k = 0; k < view.axes.size(); ++k) {
        node.row[k / 3][k % 3] = view.axes[k];
      }
      node.turned = 1;
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
  std::vector<Moments> block_moments_;
  std::vector<Moments> node_moments_;  ///< about the nodes' origins; of small nodes only
};

}  // namespace

void store(const Lanes& lanes, WideNode& node) {
  double reach = 0;
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
    reach = std::max(reach, distance);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    node.row[axis][3] = rounded_up(own[axis]);
  }
  node.reach = rounded_up(reach * (1 + 0x1p-50));  // the sum of three had two roundings
}

void lay_out(const Part& part, const PartPlan& plan, std::span<const TriangleId> primitives,
             const Mesh& mesh, const Frame& frame, std::span<WideNode> nodes,
             std::span<TriangleBlock> blocks) {
  Writer(part, plan, primitives, mesh, frame, nodes, blocks).run();
}

}  // namespace soms::layout
