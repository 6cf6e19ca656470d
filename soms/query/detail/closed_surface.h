/// \file
/// What is found of a surface while its closedness is checked, and holds at every pose.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/detail/parts/odd_edges.h"
#include "soms/geometry/mesh.h"
#include "soms/query/body.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace soms {

class ClosedBody;

namespace detail {

/// Odd edges and connected parts of a mesh.
struct ClosedSurface {
  std::vector<OddEdge> odd;
  std::vector<TriangleId> first;       ///< the first triangle of each connected part
  std::vector<std::uint32_t> part_of;  ///< of each triangle; empty where there is one part

  [[nodiscard]] std::uint32_t part(TriangleId triangle) const {
    return part_of.empty() ? 0 : part_of[triangle];
  }

  /// Edges of an odd number of triangles, those without area among them.
  [[nodiscard]] std::uint64_t odd_count() const;

  /// What closes the surface: a triangle from each odd edge to the middle of the box around the odd
  /// edges that hang together with it by vertices in one place, all where the body's pose moves it.
  /// \pre The surface is that of the body's mesh.
  [[nodiscard]] Mesh caps(const Body& body) const;

  /// True if the surface is closed where a pose moves the mesh that it is of.
  [[nodiscard]] bool is_closed(const MeshView& mesh, const Pose& pose) const;
};

/// \errors ErrorKind::cancelled.
[[nodiscard]] ClosedSurface closed_surface(const MeshView& mesh, const Limits& limits);

/// A body of whose mesh this is the surface. \errors As the constructor of ClosedBody.
[[nodiscard]] ClosedBody closed_body(Body body, std::shared_ptr<const ClosedSurface> surface);

/// That of a body that was checked.
[[nodiscard]] const ClosedSurface& surface_of(const ClosedBody& body);

}  // namespace detail

}  // namespace soms
