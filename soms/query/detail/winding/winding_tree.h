/// \file
/// The winding number of any triangles, by crossings of a ray and the boundary that is left.
///
/// Triangles T that face their ways have a boundary: their directed edges, where those that two
/// neighbors use in opposite directions cancel. The strips from its edges along an axis d, without
/// end, have the same boundary. So T and the strips turned round are a closed surface, and the
/// winding number of that is an integer: crossings of the ray against d, each 1 where the ray
/// leaves through a front and -1 where it enters through one; the ray itself, in general position,
/// crosses no strip along its own line. So
///   w(T) = crossings + sum of strips / 4 pi,
/// with nothing left of a closed surface but the integer. Where the boundary is long, as of a soup
/// or a city, triangles are a tree: nodes that are far are taken by their moments (far_field.h),
/// the others are split until little of their boundary is left; the edges along which they are cut
/// count as boundary, too.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/detail/parity/parity_traversal.h"
#include "soms/query/detail/winding/angle_sum.h"
#include "soms/query/detail/winding/boundary.h"
#include "soms/query/detail/winding/far_field.h"
#include "soms/query/detail/winding/strip_angle.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Boundaries of a body's triangles, and moments. Keeps no reference to the body.
class WindingTree {
 public:
  /// What a thread keeps from one point to the next.
  struct Memory {
    struct Crossing {
      std::uint32_t place = 0;  ///< of the triangle in the tree's order
      int sign = 0;             ///< 0: the point is on the triangle
      TriangleId triangle = 0;
    };

    std::vector<Crossing> crossings;
    std::vector<SeenCorner> seen;
  };

  /// \errors ErrorKind::cancelled.
  WindingTree(const Body& body, const Limits& limits);

  /// A bracket for the winding number of a point, whose ray along `axis`, toward greater
  /// coordinates if `forward`, meets what `met` lists. Far triangles add `width` to it at most.
  /// Triangles that the point is on count for -1/2 to 1/2 each. Nodes and edges looked at are added
  /// to `cost`.
  /// \pre `body` is that of the constructor.
  [[nodiscard]] Bracket number(const Body& body, const Vec3& point, std::size_t axis, bool forward,
                               const PointCrossings& met, double width, Memory& memory,
                               Cost& cost) const;

  /// Edges of the whole boundary, each as often as it counts.
  [[nodiscard]] std::uint64_t boundary_edges() const { return boundary_edges_; }

  [[nodiscard]] std::size_t memory() const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  /// A boundary with its corners: `from` and `to` of its edges are indices into them.
  struct Border {
    std::vector<BoundaryEdge> edges;
    std::vector<Vec3> corners;         ///< moved
    std::vector<std::uint32_t> place;  ///< of each, in the mesh: the first vertex there
  };

  /// A run of triangles, in the order of the tree.
  struct Node {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t next = 0;        ///< the node after all below it
    std::uint32_t far = kNone;     ///< its moments
    std::uint32_t border = kNone;  ///< its boundary, where it is not split further
  };

  class Builder;
  class Sum;

  void prepare(const Body& body, std::size_t axis, bool forward, const PointCrossings& met,
               Memory& memory) const;

  [[nodiscard]] Border border_of(const Body& body, std::vector<BoundaryEdge> edges) const;

  std::vector<Node> nodes_;  // in depth-first order
  std::vector<FarField> far_;
  std::vector<Border> borders_;
  std::vector<std::uint32_t> place_;   // of each triangle in the order of the tree; empty: its own
  std::vector<std::uint32_t> joined_;  // for each vertex the first one in its place
  std::uint64_t boundary_edges_ = 0;
};

}  // namespace soms::detail
