/// \file
/// The layout that queries walk: nodes of four boxes in float, rounded outward.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms {

/// Up to four boxes, side by side, with what lies in them. A box is `center +- half` about the
/// node's own origin, which is a double relative to the tree's origin: so floats are as fine as the
/// node is small, wherever the mesh lies. `center`, `half`, `own_half` and `reach` are in units of
/// the layout, 2^exponent times the mesh's; `origin` is in the mesh's own.
struct alignas(64) WideNode {
  static constexpr std::uint32_t kWidth = 4;
  static constexpr std::uint32_t kLeafBit = 0x80000000U;

  std::array<std::array<float, kWidth>, 3> center = {};  ///< axis, lane
  std::array<std::array<float, kWidth>, 3> half = {};
  std::array<std::uint32_t, kWidth> child = {};  ///< a node; with kLeafBit a leaf
  std::array<double, 3> origin = {};
  std::array<float, 3> own_half = {};  ///< box of all lanes, about the origin
  float reach = 0;                     ///< no point of a lane is farther off in the 1-norm
  std::uint32_t count = 0;             ///< lanes in use, the first ones

  [[nodiscard]] bool operator==(const WideNode&) const = default;
};

static_assert(sizeof(WideNode) == 192 && alignof(WideNode) == 64, "three cache lines");

/// Triangles of a leaf: a run of WideTree::primitives.
struct WideLeaf {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  [[nodiscard]] bool operator==(const WideLeaf&) const = default;
};

/// A canonical tree as queries walk it. Node 0 is the root; a mesh without triangles has no node.
class WideTree {
 public:
  WideTree() = default;

  /// Converts a tree of `mesh`. Children without triangles vanish; a node takes the place of its
  /// children, the largest first, until it has four. Leaves stay as large as they are.
  /// \errors ErrorKind::out_of_range beyond 2^29 nodes.
  /// \cost   O(n) time; about 90 bytes a triangle with leaves of 8.
  WideTree(const Tree& tree, const Mesh& mesh);

  [[nodiscard]] std::span<const WideNode> nodes() const { return nodes_; }

  [[nodiscard]] std::span<const WideLeaf> leaves() const { return leaves_; }

  [[nodiscard]] std::span<const TriangleId> triangles_of(const WideLeaf& leaf) const {
    return std::span(primitives_).subspan(leaf.first, leaf.count);
  }

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
  std::vector<WideLeaf> leaves_;
  std::vector<TriangleId> primitives_;
  Vec3 origin_;
  Box bounds_;
  int exponent_ = 0;
  double scale_ = 1;
};

}  // namespace soms
