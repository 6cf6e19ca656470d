/// \file
/// Edges that an odd number of triangles use, and whether together they bound anything.
#pragma once

#include "soms/base/pose.h"
#include "soms/geometry/defects.h"
#include "soms/geometry/detail/parts/buckets.h"
#include "soms/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// An edge whose uses are odd in number, among all triangles or among those with area.
struct OddEdge {
  std::array<std::uint32_t, 2> ends;  ///< vertices, each the first in its place
  EdgePlace place;                    ///< of the first triangle that uses it
  bool among_all;                     ///< an odd number of all triangles use it
  bool among_proper;                  ///< an odd number of triangles with area use it
};

/// A segment between two places.
using Segment = std::array<Vec3, 2>;

/// True if on every line each point but the ends lies on an even number of segments: exactly.
///
/// Along a line the number of segments over a point changes only at their ends, and is 0 far out.
/// So it is even everywhere if and only if at each end, and on each line through it, an even number
/// of segments begin or end. Segments from a point to itself count for nothing.
/// \cost O(n log n) comparisons for n segments.
[[nodiscard]] bool covers_evenly(std::span<const Segment> segments);

/// For each segment the number of its line. Segments of one line that hang together by common ends,
/// each with the next, have one number; others of the same line may have another. \pre No segment
/// is from a point to itself.
/// \cost As `covers_evenly`.
[[nodiscard]] std::vector<std::uint32_t> lines_of(std::span<const Segment> segments);

/// The first axis on which two places differ.
[[nodiscard]] inline std::size_t leading_axis(const Vec3& p, const Vec3& q) {
  return p.x != q.x ? 0 : p.y != q.y ? 1 : 2;
}

/// `covers_evenly` of the edges that are odd among all triangles, where a pose moves their ends.
/// \cost O(n) where an end of the first edge tells that they do not, as mostly; else as
///       `covers_evenly`.
[[nodiscard]] bool cover_evenly(const MeshView& mesh, std::span<const OddEdge> edges,
                                const Pose& pose);

/// Triangles without area, by number: exactly. Takes one loop over the triangles of `work`.
[[nodiscard]] std::vector<bool> degenerate_triangles(const MeshView& mesh, Work& work);

/// Odd edges of a mesh, by place. `joined` is what `joined_by_position` gives. Takes
/// `odd_edges_work` of `work`.
[[nodiscard]] std::vector<OddEdge> odd_edges(const MeshView& mesh,
                                             const std::vector<std::uint32_t>& joined,
                                             const std::vector<bool>& degenerate, Work& work);

/// The same of a mesh whose vertices are not joined yet.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<OddEdge> odd_edges(const MeshView& mesh, const Limits& limits);

/// Loops of `odd_edges`.
[[nodiscard]] std::uint64_t odd_edges_work(const MeshView& mesh);

/// Odd edges of a run of triangles by itself, in any order.
/// \cost O(n log n)
[[nodiscard]] std::vector<OddEdge> odd_edges_of_run(const MeshView& mesh,
                                                    const std::vector<std::uint32_t>& joined,
                                                    const std::vector<bool>& degenerate,
                                                    const Part& run);

}  // namespace soms::detail
