/// \file
/// The layout that queries walk: nodes of four boxes in float, rounded outward.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/layout/orientation.h"
#include "soms/tree/tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

  std::array<std::array<float, kWidth>, 3> center = {};  ///< axis, lane
  std::array<std::array<float, kWidth>, 3> half = {};
  std::array<std::uint32_t, kWidth> child = {};  ///< a node, or kLeafBit with a leaf's first block
  std::array<double, 3> origin = {};
  std::array<float, 3> own_half = {};  ///< box of all lanes, about the origin
  float reach = 0;                     ///< no point of a lane is farther off in the 1-norm
  layout::Axes axes = layout::kMeshAxes;
  std::uint16_t count = 0;   ///< lanes in use, the first ones
  std::uint16_t turned = 0;  ///< 1 unless `axes` are the mesh's

  [[nodiscard]] bool operator==(const WideNode&) const = default;
};

static_assert(sizeof(WideNode) == 192 && alignof(WideNode) == 64, "three cache lines");

/// Up to eight triangles of a leaf, corners in float about the block's own origin, in units of the
/// layout, along axes of its own. A leaf of more triangles is a run of blocks.
struct alignas(64) TriangleBlock {
  static constexpr std::uint32_t kWidth = 8;

  /// Row 3 * corner + axis, lane; rounded to nearest. Lanes not in use repeat the last triangle.
  std::array<std::array<float, kWidth>, 9> corner = {};
  std::array<TriangleId, kWidth> id = {};
  std::array<double, 3> origin = {};
  std::array<float, 3> own_half = {};  ///< box of all triangles, about the origin
  float reach = 0;                     ///< no point is farther off in the 1-norm
  layout::Axes axes = layout::kMeshAxes;
  std::uint16_t count = 0;      ///< triangles, the first lanes
  std::uint16_t turned = 0;     ///< 1 unless `axes` are the mesh's
  std::uint32_t following = 0;  ///< blocks of the same leaf that follow this one

  [[nodiscard]] bool operator==(const TriangleBlock&) const = default;
};

static_assert(sizeof(TriangleBlock) == 448 && alignof(TriangleBlock) == 64, "seven cache lines");

/// A canonical tree as queries walk it. Node 0 is the root; a mesh without triangles has no node.
class WideTree {
 public:
  WideTree() = default;

  /// Converts a tree of `mesh`. Children without triangles vanish; a node takes the place of its
  /// children, the largest first, until it has four. Leaves stay as large as they are, cut into
  /// blocks. Small nodes and blocks take the principal axes of what they hold for their frame where
  /// boxes get a tenth smaller by it.
  /// \errors ErrorKind::out_of_range beyond 2^30 nodes or blocks.
  /// \cost   O(n) time; about 100 bytes a triangle with leaves of 8.
  WideTree(const Tree& tree, const Mesh& mesh);

  [[nodiscard]] std::span<const WideNode> nodes() const { return nodes_; }

  [[nodiscard]] std::span<const TriangleBlock> blocks() const { return blocks_; }

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

  [[nodiscard]] bool operator==(const WideTree&) const = default;

 private:
  std::vector<WideNode> nodes_;
  std::vector<TriangleBlock> blocks_;
  Vec3 origin_;
  Box bounds_;
  int exponent_ = 0;
  double scale_ = 1;
};

}  // namespace soms
