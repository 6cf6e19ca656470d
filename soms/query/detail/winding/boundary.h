/// \file
/// The boundary of triangles that face one way: their directed edges, where those of neighbors
/// cancel.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// An edge of a boundary: of its uses, so many more lead from the first end to the second than
/// back. Never 0 and, as stored, positive.
struct BoundaryEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::int32_t times = 1;

  [[nodiscard]] bool operator==(const BoundaryEdge&) const = default;
};

/// Adds the three edges of a triangle, by its corners, as often as `times` says; negative: turned
/// round. Edges from a place to itself are left out.
void add_edges(const std::array<std::uint32_t, 3>& corners, std::int32_t times,
               std::vector<BoundaryEdge>& edges);

/// Puts uses of the same edge together and drops what cancels: sorted by the lesser end, then by
/// the other one, whatever the order was.
/// \cost O(n log n)
void cancel(std::vector<BoundaryEdge>& edges);

}  // namespace soms::detail
