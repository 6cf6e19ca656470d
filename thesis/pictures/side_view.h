/// \file
/// Meshes and boxes seen along an axis, without perspective, as SVG paths.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"

#include "apps/draw/svg.h"

#include <cstddef>
#include <span>
#include <string>

namespace soms::reproduce {

/// From where one looks; y is up.
enum class Side {
  front,  ///< from +z: x to the right
  right,  ///< from +x: -z to the right
};

/// Where on the page a part of space stands.
struct PagePlace {
  Spot corner;  ///< upper left
  double width = 0;
  double height = 0;
};

/// Looks along an axis at a part of space and puts it into a rectangle of a page, in the middle and
/// as large as fits.
class SideView {
 public:
  /// \pre `shown` is not empty.
  SideView(Side side, const Box& shown, const PagePlace& place);

  [[nodiscard]] Spot operator()(const Vec3& point) const;

  /// Path of the triangles of a moved mesh that face the viewer (counter-clockwise corners).
  [[nodiscard]] std::string facing(const MeshView& mesh, const Vec3& offset) const;

  /// Path of some triangles of a moved mesh, all of them whatever they face.
  [[nodiscard]] std::string triangles(const MeshView& mesh, std::span<const TriangleId> which,
                                      const Vec3& offset) const;

  /// Path of the outline of a box; empty for an empty box.
  [[nodiscard]] std::string box(const Box& box) const;

 private:
  Side side_;
  Spot middle_;       ///< of the rectangle
  Vec3 center_;       ///< of the part of space
  double scale_ = 1;  ///< pixels a unit
};

}  // namespace soms::reproduce
