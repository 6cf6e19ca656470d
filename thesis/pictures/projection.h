/// \file
/// From space to the page: directions, depths, and which triangles are seen at all.
#pragma once

#include "apps/draw/eye.h"
#include "apps/draw/svg.h"
#include "thesis/pictures/drawing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::reproduce {

/// Directions of a view.
[[nodiscard]] look::CameraFrame frame_of(const View& view);

/// True if a view is along an axis: boxes are rectangles.
[[nodiscard]] bool is_flat(const look::CameraFrame& frame);

/// Corners of a box; corner k has the upper x, y, z for the bits 1, 2, 4 of k.
[[nodiscard]] std::array<Vec3, 8> corners(const Box& box);

/// The corner of a box that it hides from the eye.
[[nodiscard]] std::size_t far_corner(const std::array<Vec3, 8>& corners,
                                     const look::CameraFrame& from);

/// The edges of a box on the page: those before it, and the three that it hides.
struct BoxEdges {
  PathData front;
  PathData hidden;
};

/// \param spots Where the corners are on the page. \param far As of `far_corner`.
[[nodiscard]] BoxEdges edges_of(const std::array<Spot, 8>& spots, std::size_t far);

/// Bounds on the page.
struct PageBounds {
  double left = 1e300;
  double top = 1e300;
  double right = -1e300;
  double bottom = -1e300;

  void take(const Vec3& seen);
  void take(const look::CameraFrame& from, const Box& box);

  [[nodiscard]] double width() const { return std::max(right - left, 1e-300); }

  [[nodiscard]] double height() const { return std::max(bottom - top, 0.0); }
};

/// A triangle on the page, in pixels of its panel.
struct Facet {
  std::array<Vec3, 3> corners = {};  ///< z: depth
  int color = kClay;
  double brightness = 1;
  bool whole = true;          ///< false for a piece of a facet that was cut: its edges are no edges
  std::uint32_t samples = 0;  ///< of four a pixel, how many show it

  [[nodiscard]] double farthest() const;
};

/// Counts the samples that show each facet and drops those that none shows; those that remain are
/// in painter's order: far ones first.
void keep_visible(std::vector<Facet>& facets, double width, double height);

/// Cuts facets in two across their longest side until no side is longer than `pixels`, so that
/// painter's order can put them where they belong.
void cut_long(std::vector<Facet>& facets, double pixels);

}  // namespace soms::reproduce
