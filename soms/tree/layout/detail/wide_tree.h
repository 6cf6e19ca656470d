/// \file
/// The layout that queries traverse: nodes of four boxes in float, rounded outward.
#pragma once

#include "soms/base/box.h"
#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/layout/detail/min_max_grid.h"
#include "soms/tree/layout/detail/node_axes.h"
#include "soms/tree/layout/detail/pages.h"
#include "soms/tree/layout/detail/start_nodes.h"
#include "soms/tree/layout/detail/stored.h"
#include "soms/tree/tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace soms {

/// Up to four boxes, side by side, with what lies in them. A box is `center +- half` in the node's
/// frame, about the node's origin, which is a double relative to the tree's origin: so floats are
/// as fine as the node is small, wherever the mesh lies. Floats are in units of the layout,
/// 2^exponent times the mesh's; `origin` is in the mesh's own. A leaf of several blocks has kRunBit
/// in its parent's lane.
struct alignas(64) WideNode {
  static constexpr std::uint32_t kWidth = 4;
  static constexpr std::uint32_t kLeafBit = 0x80000000U;
  static constexpr std::uint32_t kRunBit = 0x40000000U;
  static constexpr std::uint32_t kMost = 0x10000000U;  ///< nodes and blocks are fewer than this

  std::array<std::array<float, kWidth>, 3> center = {};  ///< axis, lane
  std::array<std::array<float, kWidth>, 3> half = {};
  /// Row i of the frame's axes; its fourth entry is half side i of a box of all lanes, about the
  /// origin.
  std::array<std::array<float, 4>, 3> row = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  std::array<std::uint32_t, kWidth> child = {};  ///< a node, or kLeafBit with a leaf's first block
  std::array<double, 3> origin = {};
  float l1_radius = 0;        ///< no point of a lane is farther off in the 1-norm
  std::uint8_t count = 0;     ///< lanes in use, the first ones
  std::uint8_t leaves = 0;    ///< bit k: lane k is a leaf
  std::uint8_t oriented = 0;  ///< 1 unless the axes are the mesh's

  [[nodiscard]] std::array<float, 3> own_half() const { return {row[0][3], row[1][3], row[2][3]}; }

  [[nodiscard]] layout::Axes axes() const {
    return {row[0][0], row[0][1], row[0][2], row[1][0], row[1][1],
            row[1][2], row[2][0], row[2][1], row[2][2]};
  }

  [[nodiscard]] bool operator==(const WideNode&) const = default;
};

static_assert(sizeof(WideNode) == 192 && alignof(WideNode) == 64, "three cache lines");

/// Up to eight triangles of a leaf, corners in float about the block's own origin, in units of the
/// layout, along the mesh's axes. A leaf of more triangles is a run of blocks.
struct alignas(64) TriangleBlock {
  static constexpr std::uint32_t kWidth = 8;

  /// Row 3 * corner + axis, lane; rounded to nearest. Lanes not in use repeat the last triangle.
  std::array<std::array<float, kWidth>, 9> corner = {};
  std::array<TriangleId, kWidth> id = {};
  std::array<double, 3> origin = {};
  std::array<float, 3> own_half = {};  ///< box of all triangles, about the origin
  float l1_radius = 0;                 ///< no point is farther off in the 1-norm
  /// All points v have lower <= normal v <= upper. The normal is of length 1 to 2^-22; it is the
  /// triangles' mean normal where they have one, as what touches no leaf mostly passes beside it.
  std::array<float, 3> normal = {};
  float lower = 0;
  float upper = 0;
  std::uint32_t count : 4 = 0;       ///< triangles, the first lanes
  std::uint32_t following : 28 = 0;  ///< blocks of the same leaf that follow this one

  [[nodiscard]] bool operator==(const TriangleBlock&) const = default;
};

static_assert(sizeof(TriangleBlock) == 384 && alignof(TriangleBlock) == 64, "six cache lines");

namespace layout {
struct Parts;
}

struct CompactNode;

/// The least that a tree can be kept as: its nodes with boxes in bytes, and the triangles of its
/// leaves one after the other. The last one of each leaf has kLast.
struct CompactParts {
  static constexpr std::uint32_t kLast = 0x80000000U;

  layout::Stored<CompactNode> nodes;
  layout::Stored<std::uint32_t> ids;
};

/// The arrays that a layout is made of, whoever holds them; those of the other kind are empty.
struct LayoutArrays {
  std::span<const WideNode> nodes;
  std::span<const TriangleBlock> blocks;
  std::span<const TriangleId> least_ids;
  std::span<const layout::MinMaxGrid::Cell> cells;  ///< none without a ground plan
  std::span<const std::uint32_t> list_ends;
  std::span<const std::uint32_t> list_nodes;
  std::span<const CompactNode> compact_nodes;
  std::span<const std::uint32_t> compact_ids;
  layout::GroundPlan plan;
  Box bounds;
};

/// A canonical tree as queries traverse it. Node 0 is the root; a mesh without triangles has no
/// node.
class WideTree {
 public:
  WideTree() = default;

  /// Converts a tree of `mesh`. Children without triangles vanish; a node takes the place of its
  /// children, the largest first, until it has four. Leaves stay as large as they are, cut into
  /// blocks. Small nodes take the principal axes of what they hold for their frame where boxes get
  /// a tenth smaller by it. The same bytes for any number of threads.
  /// \errors ErrorKind::out_of_range beyond 2^28 nodes or blocks; cancelled.
  /// \cost   O(n) time; about 80 bytes a triangle with leaves of 8.
  WideTree(const Tree& tree, const MeshView& mesh, const Limits& limits = {});

  /// The same from a tree that was never put together; it must not be empty.
  WideTree(const layout::Parts& tree, const MeshView& mesh, const Limits& limits = {});

  /// The same nodes and leaves over a mesh whose vertices were moved; its triangles must be the
  /// same. Boxes, places and frames are made as for a new tree: where no vertex moved, the bytes
  /// are those of `tree`. The same for any number of threads.
  /// \errors cancelled.
  /// \cost   O(n) time.
  WideTree(const WideTree& tree, const MeshView& mesh, const Limits& limits = {});

  /// A layout over arrays that something else holds, which it keeps by `owner`.
  /// \pre They are safe to traverse: `soms/tree/file/` says what that takes, and checks it.
  WideTree(const LayoutArrays& arrays, std::shared_ptr<const void> owner);

  /// The arrays, for as long as the layout lives.
  [[nodiscard]] LayoutArrays arrays() const;

  /// The same tree in a third of the memory: nodes in bytes, and no blocks. Boxes grow by up to a
  /// 127th of their node, and blocks are made again whenever they are read.
  /// \errors ErrorKind::out_of_range beyond 2^28 triangles; cancelled.
  /// \cost   O(n) time
  [[nodiscard]] WideTree compacted(const Limits& limits = {}) const;

  /// A compact tree with its nodes and blocks written out: the tree that was compacted, but for its
  /// boxes' sizes. `mesh` is the tree's.
  [[nodiscard]] WideTree expanded(const MeshView& mesh, const Limits& limits = {}) const;

  [[nodiscard]] bool empty() const { return nodes_.empty() && !compact_; }

  /// What a compact tree is made of, nullptr in others.
  [[nodiscard]] const CompactParts* compact() const { return compact_.get(); }

  /// Nodes and blocks; none where the tree is compact.
  [[nodiscard]] std::span<const WideNode> nodes() const { return nodes_; }

  [[nodiscard]] std::span<const TriangleBlock> blocks() const { return blocks_; }

  /// The least triangle below each node, of a compact tree, too.
  [[nodiscard]] std::span<const TriangleId> least_ids() const { return least_ids_; }

  /// Where a tree of a flat mesh has nothing; empty for others, and where the tree is compact.
  [[nodiscard]] const layout::MinMaxGrid& min_max_grid() const { return min_max_grid_; }

  /// Where small boxes begin; only beside a height grid.
  [[nodiscard]] const layout::StartNodes& start_nodes() const { return start_nodes_; }

  /// The block that begins at entry `first` of `CompactParts::ids`. Where `following` is 1 the leaf
  /// goes on kWidth entries later.
  /// \pre The tree is compact; `mesh` is its mesh.
  void read_block(std::uint32_t first, const MeshView& mesh, TriangleBlock& block) const;

  /// Point of the mesh's frame that node origins are relative to.
  [[nodiscard]] const Vec3& origin() const { return origin_; }

  /// Bounds of the mesh.
  [[nodiscard]] const Box& bounds() const { return bounds_; }

  /// Floats are the mesh's numbers times 2^exponent: 0 for bodies of usual size, else such that the
  /// longest side of the mesh's box is about 1.
  [[nodiscard]] int exponent() const { return exponent_; }

  /// 2^exponent.
  [[nodiscard]] double scale() const { return scale_; }

  [[nodiscard]] std::size_t memory() const;

  /// Area of all boxes over the area of the triangles: how much room a query finds to enter in
  /// vain. It grows when vertices move away from those beside them. 0 where triangles have no area.
  /// `mesh` is the tree's. \cost O(n)
  [[nodiscard]] double sah_area_ratio(const MeshView& mesh, const Limits& limits = {}) const;

  [[nodiscard]] bool operator==(const WideTree& other) const;

 private:
  /// Takes place and unit from the bounds; returns the longest side in that unit.
  [[nodiscard]] double settle();

  /// Makes what flat meshes have beside nodes and blocks.
  void make_plan(const Limits& limits);

  std::shared_ptr<const void> owner_;  ///< of arrays that are borrowed
  layout::Stored<WideNode> nodes_;
  layout::Stored<TriangleBlock> blocks_;
  layout::Stored<TriangleId> least_ids_;
  layout::MinMaxGrid min_max_grid_;
  layout::StartNodes start_nodes_;
  std::shared_ptr<const CompactParts> compact_;
  Vec3 origin_;
  Box bounds_;
  int exponent_ = 0;
  double scale_ = 1;
};

}  // namespace soms
