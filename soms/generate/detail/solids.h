/// \file
/// Closed solids that generated scenes and movers are put together from.
#pragma once

#include "soms/base/vector.h"
#include "soms/generate/detail/circle.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace soms::detail {

/// A place with right-handed axes of unit length.
struct Frame {
  Vec3 origin;
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};

  [[nodiscard]] Vec3 at(double u, double v, double w) const {
    return origin + u * x + v * y + w * z;
  }

  /// The same axes about another origin, given in this frame.
  [[nodiscard]] Frame moved(double u, double v, double w) const { return {at(u, v, w), x, y, z}; }
};

/// An upright frame that is turned about z.
[[nodiscard]] Frame upright(const Vec3& origin, const OnCircle& turn);

/// The axes of `frame` in the order y, z, x: an outline of (y, z) is then extruded along x.
[[nodiscard]] Frame lengthwise(const Frame& frame);

/// The axes of `frame` in the order z, x, y: an outline of (z, x) is then extruded along y.
[[nodiscard]] Frame crosswise(const Frame& frame);

/// A corner of an outline in a frame's x and y.
struct Corner {
  double x = 0;
  double y = 0;
};

/// Outlines turn counter-clockwise and are seen whole from their first corner.
using Outline = std::vector<Corner>;

[[nodiscard]] Outline rectangle(double half_x, double half_y);
[[nodiscard]] Outline regular(std::size_t corners, double radius);

/// Triangles of a solid between two outlines of `corners` corners.
[[nodiscard]] constexpr std::uint64_t prism_triangles(std::uint64_t corners) {
  return 4 * corners - 4;
}

/// Solid between `lower` at height `from` and `upper` at height `to`, of equally many corners.
void add_frustum(Mesh& mesh, const Frame& frame, std::span<const Corner> lower,
                 std::span<const Corner> upper, double from, double to);

/// Outline extruded from height `from` to height `to`.
void add_prism(Mesh& mesh, const Frame& frame, std::span<const Corner> outline, double from,
               double to);

/// Box of 12 triangles about the origin of the frame.
void add_box(Mesh& mesh, const Frame& frame, const Vec3& half);

/// Outline with a hole of equally many corners, extruded; 8 triangles a corner.
void add_ring(Mesh& mesh, const Frame& frame, std::span<const Corner> outer,
              std::span<const Corner> inner, double from, double to);

/// Ellipsoid of two poles and `rings` rings of `around` points: 2 * around * rings triangles.
/// `swell` scales each ring point's distance from the axis; empty means 1.
void add_ellipsoid(Mesh& mesh, const Frame& frame, const Vec3& radii, std::uint32_t around,
                   std::uint32_t rings, std::span<const double> swell = {});

/// Opens a part at the end of the mesh; its count is set when it is closed.
[[nodiscard]] std::uint32_t open_part(Mesh& mesh, std::string name,
                                      std::uint32_t parent = Part::kNoParent);
void close_part(Mesh& mesh, std::uint32_t part);

}  // namespace soms::detail
