/// \file
/// The tests of boxes and triangles that a traversal lives on, once for each instruction set. All
/// give the same bits: every lane is a float, each product and each sum is rounded by itself, in
/// the same order. A bit that is not set means surely apart; relative_pose.h proves the margins.
#pragma once

#include "soms/query/detail/kernels/line_tasks.h"
#include "soms/query/detail/kernels/parity_tasks.h"
#include "soms/query/detail/kernels/pose_tasks.h"
#include "soms/query/detail/kernels/triangle_tasks.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// What kernels need to know of a relative pose: N, D and the margins of relative_pose.h. Most
/// queries of a small body end before the arrays of N are needed: they stay unwritten till then.
struct alignas(64) PoseNumbers {
  alignas(64) std::array<float, 16> rows;  ///< of N in float, padded by zeros
  std::array<float, 16> magnitudes;        ///< of their entries
  std::array<float, 16> columns;           ///< the rows of its transpose
  /// Columns of N, and D, in double; padded by zeros.
  std::array<std::array<double, 4>, 3> column;
  std::array<double, 4> shift = {};
  double scale = 1;    ///< turns the mesh's units into those of y's layout
  float ratio = 1;     ///< turns lengths of x's layout into those of y's
  float relative = 0;  ///< margin for each unit of the nodes' L1 radius
  float slack = 0;     ///< margin for the poses' rounding, and for gaps that count as none
  float rounding = 0;  ///< margin for the poses' rounding alone
  float shrink = 0;    ///< what lengths of gaps are multiplied by to be lower bounds (near_pose.h)

  [[nodiscard]] float n(std::size_t i, std::size_t j) const { return rows[4 * i + j]; }

  /// From the origin of a node or block in y to that of one in x, in y's units and axes.
  [[nodiscard]] std::array<double, 3> offset_in_double(const std::array<double, 3>& x,
                                                       const std::array<double, 3>& y) const {
    std::array<double, 3> d = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const double rotated = (column[0][i] * x[0] + column[1][i] * x[1]) + column[2][i] * x[2];
      d[i] = ((rotated + shift[i]) - y[i]) * scale;
    }
    return d;
  }

  /// The same, rounded to floats.
  [[nodiscard]] std::array<float, 3> offset(const std::array<double, 3>& x,
                                            const std::array<double, 3>& y) const {
    const std::array<double, 3> d = offset_in_double(x, y);
    return {static_cast<float>(d[0]), static_cast<float>(d[1]), static_cast<float>(d[2])};
  }
};

/// A node of x against a node of y. A node or leaf that is still to be descended has a node id:
/// eight times a node's index, or that of its parent with kLane and the lane for a leaf.
struct NodeTask {
  static constexpr std::uint32_t kLane = 4;

  const PoseNumbers* pose;
  const WideNode* x;
  const WideNode* y;
  std::uint32_t node_id_x;  ///< of the nodes themselves
  std::uint32_t node_id_y;
  std::uint32_t pairs;  ///< in: wanted, bit 4 r + k for lane k of x and lane (k + r) mod 4 of y;
                        ///< out: those that meet; where one node is descended alone, its lanes
  std::uint32_t order;  ///< in: 1 if the nearest pair of node ids is to end on top
  std::uint32_t below;  ///< out, where `order` is 1: all bits below the nearest pair's

  /// Pairs of which one at least is a node.
  [[nodiscard]] inline std::uint32_t node_ids() const;

  /// x is the larger node.
  [[nodiscard]] bool descends_x() const { return x->l1_radius * pose->ratio > y->l1_radius; }
};

/// A block of x against a block of y.
struct BlockTask {
  const PoseNumbers* pose;
  const TriangleBlock* x;
  const TriangleBlock* y;
  std::array<float, 3> offset;  ///< out, with what follows
  float margin;
  std::uint32_t lanes_x;  ///< triangles that may meet the other block's slab; 0: blocks are apart
  std::uint32_t lanes_y;
};

/// Lists of pairs that kernels append to; there is room for 16 more pairs of each kind and task.
struct PairSink {
  std::uint32_t* node_ids_x;
  std::uint32_t* node_ids_y;
  std::uint32_t* blocks_x;  ///< tokens of WideNode::child
  std::uint32_t* blocks_y;
  std::size_t node_ids = 0;  ///< appended so far
  std::size_t blocks = 0;
};

/// Brings pair `which` of the `count` pairs of node ids that follow in the sink to their end.
inline void put_last(const PairSink& sink, std::size_t which, std::size_t count) {
  const std::size_t last = count - (count != 0 ? 1 : 0);
  for (std::uint32_t* list : {sink.node_ids_x + sink.node_ids, sink.node_ids_y + sink.node_ids}) {
    const std::uint32_t nearest = list[which];
    list[which] = list[last];
    list[last] = nearest;
  }
}

/// Lower bounds of the distances of a task's pairs, by the bits of NodeTask::pairs. Where boxes
/// meet, the largest gap of an axis, which is at most 0. Those of pairs not wanted may be anything.
struct alignas(64) NodeKeys {
  std::array<float, 16> key;
  std::uint32_t near;  ///< wanted pairs whose keys do not exceed the limit
};

/// A box seen from a block of triangles.
struct SeenBox {
  std::array<float, 3> center;
  std::array<float, 3> half;
  std::array<std::array<float, 4>, 3> axis;  ///< axis j of the box is column j; rows padded to four
  std::array<float, 3> radius;               ///< along the block's axes, margin and reach included
  float margin;
  float reach;  ///< what may lie between, beside the margin
};

/// Distances of pairs of triangles.
struct alignas(64) PairGaps {
  std::array<float, kJudged> lower;                ///< proved lower bounds, some below 0
  std::array<float, kJudged> estimate;             ///< the distances, more or less, if near
  std::array<std::array<float, kJudged>, 3> line;  ///< from the first triangle to the second
  std::uint32_t near;                              ///< pairs whose bounds are within the reach
};

/// What makes a pair of triangles near, in units of y's layout.
struct NearFilter {
  float reach;                     ///< what counts as near (near_pose.h)
  std::array<float, 3> direction;  ///< some direction from x to y, of length 1 or below
};

/// A point beside a tree (near/point_pose.h).
struct PointNumbers {
  std::array<double, 3> place =
      {};            ///< from the tree's origin, along the mesh's axes, in its units
  double scale = 1;  ///< turns them into those of the layout
  float slack = 0;   ///< margin for the rounding of the place and of moved vertices

  /// From the origin of a node or block to the point, in the layout's units.
  [[nodiscard]] std::array<float, 3> offset(const std::array<double, 3>& origin) const {
    std::array<float, 3> d = {};
    for (std::size_t i = 0; i < 3; ++i) {
      d[i] = static_cast<float>((place[i] - origin[i]) * scale);
    }
    return d;
  }
};

/// Lower bounds of a point's distances from a node's boxes; where it is inside, the largest gap of
/// an axis, which is at most 0. Those of lanes not in use may be anything.
struct alignas(16) PointNodeKeys {
  std::array<float, WideNode::kWidth> key;
};

/// Distances of a point from a block's triangles. Those of lanes not in use repeat the last one.
struct alignas(32) PointBlockKeys {
  std::array<float, TriangleBlock::kWidth> key;       ///< proved lower bounds, some below 0
  std::array<float, TriangleBlock::kWidth> estimate;  ///< the distances, more or less
};

/// Pairs of triangles with corners in common, side by side (neighbors.h). Lanes not in use may have
/// any numbers.
struct alignas(64) NeighborLanes {
  static constexpr std::size_t kMost = 8;
  using Row = std::array<double, kMost>;

  /// Row 3 * corner + axis, lane. Triangles with a corner in common are (0, 1, 2) and (0, 3, 4);
  /// with an edge, (0, 1, 2) and (0, 1, 3).
  std::array<Row, 15> corner = {};
};

/// One instruction set's tests.
struct Kernels {
  const char* name;

  /// Tests pairs of lanes of nodes on six axes, the three of each; keeps those that meet.
  void (*test_nodes)(NodeTask* tasks, std::size_t count);

  /// Tests the lanes of the larger node against the other's box of all lanes; keeps those that
  /// meet.
  void (*test_larger)(NodeTask* tasks, std::size_t count);

  /// Appends what is set in `pairs` to the sink.
  void (*append)(const NodeTask* tasks, std::size_t count, PairSink& sink);

  /// Tests the triangles of each block against the slab of the other's.
  void (*test_slabs)(BlockTask* tasks, std::size_t count);

  /// Triangles of two blocks that passed the slabs, by their boxes: bit k of byte i for lane i of x
  /// and lane k of y. Fills the slot unless there is none.
  std::uint64_t (*test_boxes)(const BlockTask& task, TriangleSlot& slot);

  /// Triangles of a block, multiplied by `ratio`, that may meet a box: bit k for lane k. Seven
  /// axes: three of each, and the triangle's normal; those in its plane if the block is larger.
  std::uint32_t (*meet_box)(const SeenBox& box, const TriangleBlock& block, float ratio);

  /// Judges `count` pairs of triangles, at most kJudged. Each list has kJudged places in the slots,
  /// counted in floats from the first one's x; those from `count` on may be any in use.
  Verdicts (*judge)(const TriangleSlot* slots, const std::uint32_t* first,
                    const std::uint32_t* second, std::size_t count);

  /// Judges `count` pairs of triangles, at most kJudged, that `judge` left open, more closely
  /// (triangle_pairs_double.h). A pair is 64 times its slot, eight times the lane of x and that of
  /// y. \pre `test_boxes` filled the slots.
  Verdicts (*judge_in_double)(const TriangleSlot* slots, const PoseNumbers& pose,
                              const std::uint16_t* pairs, std::size_t count);

  /// Bounds the distances of pairs of lanes (near_nodes.h).
  void (*bound_nodes)(const NodeTask* tasks, std::size_t count, float limit, NodeKeys* keys);

  /// As `test_boxes`, for triangles whose boxes are near.
  std::uint64_t (*near_boxes)(const BlockTask& task, const NearFilter& filter, TriangleSlot& slot);

  /// Bounds the distances of pairs of triangles, in the layout's units; lists as for `judge`. Those
  /// beyond `reach` have a bound, but perhaps no estimate: infinity.
  void (*near_pairs)(const TriangleSlot* slots, const std::uint32_t* first,
                     const std::uint32_t* second, std::size_t count, float reach, PairGaps& gaps);

  /// Bounds the distances of a point from the boxes of a node, and from the triangles of a block
  /// (point_bounds.h).
  void (*bound_boxes)(const PointNumbers& point, const WideNode& node, PointNodeKeys& keys);
  void (*bound_triangles)(const PointNumbers& point, const TriangleBlock& block,
                          PointBlockKeys& keys);

  /// Lanes of nodes that a ray may meet (parity.h).
  void (*ray_nodes)(RayNodeTask* tasks, std::size_t count);

  /// Triangles of blocks that a ray surely meets, and those that floats cannot decide.
  void (*ray_blocks)(RayBlockTask* tasks, std::size_t count);

  /// How many poses, from the first on, surely pass their checks: `far` are the largest magnitudes
  /// of coordinates of the bounds that they move.
  std::size_t (*passing_poses)(const Pose* poses, std::size_t count, const Vec3& far);

  /// Pairs that surely share nothing but their common corner, or edge.
  std::uint32_t (*apart_at_corner)(const NeighborLanes& lanes);
  std::uint32_t (*apart_at_edge)(const NeighborLanes& lanes);

  /// Finds the relative poses of `count` poses, at least one and at most RelativePoses::kMost.
  void (*relative_poses)(const MovedNumbers& x, const ReferenceNumbers& y, const BoxNumbers& box,
                         const Pose* const* poses, std::size_t count, RelativePoses& found);

  /// Takes rays in any direction, kMostDescents at most, down a tree (lines.h): each enters nodes,
  /// the nearest one first, until a block is the next to be looked at, nothing is, there is no room
  /// for a node's boxes, or it has made its steps. They take turns, so that one computes while
  /// others load.
  void (*line_descents)(const WideNode* nodes, LineDescent* const* descents, std::size_t count);

  /// Puts a node's boxes that a ray may meet on its stack, which has room for them.
  void (*line_node)(const WideNode& node, LineDescent& descent);

  /// `ray_blocks` for a ray in any direction.
  void (*line_block)(LineBlockTask& task);
};

/// Where rotation r pairs lanes k of `x` with lanes (k + r) mod 4 of `y`.
constexpr std::uint32_t pairs_of_lanes(std::uint32_t x, std::uint32_t y) {
  std::uint32_t bits = 0;
  for (std::uint32_t r = 0; r < 4; ++r) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      bits |= (x >> k & y >> (k + r) % 4 & 1U) << (4 * r + k);
    }
  }
  return bits;
}

/// `pairs_of_lanes` for all sets of lanes.
struct LanePairs {
  std::array<std::array<std::uint16_t, 16>, 16> bits = {};

  constexpr LanePairs() {
    for (std::uint32_t x = 0; x < 16; ++x) {
      for (std::uint32_t y = 0; y < 16; ++y) {
        bits[x][y] = static_cast<std::uint16_t>(pairs_of_lanes(x, y));
      }
    }
  }
};

inline constexpr LanePairs kLanePairs;

inline std::uint32_t NodeTask::node_ids() const {
  return pairs & ~std::uint32_t{kLanePairs.bits[x->leaves][y->leaves]};
}

}  // namespace soms::detail
