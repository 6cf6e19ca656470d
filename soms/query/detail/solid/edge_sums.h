/// \file
/// Edges of triangles, counted modulo two by what lies along them.
#pragma once

#include "soms/base/vector.h"
#include "soms/query/detail/solid/planar_triangles.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soms::detail {

/// A segment; its direction does not count.
struct PlanarEdge {
  Vec3 from;
  Vec3 to;
};

/// Edges in one plane. Two triangles of one body and kind that have an edge in common change the
/// same across it: nothing, together.
class EdgeSums {
 public:
  /// An edge of a triangle of `body`.
  void add(const Vec3& p, const Vec3& q, std::size_t body, CutKind kind);

  /// Each edge that has an odd number of triangles of some body and kind, once. Edges without
  /// length are left out. \cost O(n log n). Orders what was added.
  [[nodiscard]] std::vector<PlanarEdge> odd();

 private:
  struct Entry {
    PlanarEdge edge;
    unsigned kinds;  // one bit
  };

  std::vector<Entry> entries_;
};

}  // namespace soms::detail
