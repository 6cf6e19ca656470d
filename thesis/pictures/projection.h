/// \file
/// From space to the page: places, depths, shades, and which triangles are seen at all.
#pragma once

#include "apps/draw/svg.h"
#include "thesis/pictures/drawing.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::reproduce {

/// A point on the page, before scaling, with its distance from the eye.
struct Seen {
  double x = 0;
  double y = 0;  ///< downwards
  double depth = 0;
};

/// A parallel projection.
class Projection {
 public:
  explicit Projection(const View& view);

  [[nodiscard]] Seen see(const Vec3& point) const;

  /// True if the view is along an axis: boxes are rectangles.
  [[nodiscard]] bool flat() const { return flat_; }

  /// Brightness of a triangle, 0 to 1, lit from the upper left of the eye.
  [[nodiscard]] double brightness(const Triangle& triangle) const;

 private:
  Vec3 right_;
  Vec3 down_;
  Vec3 toward_;
  Vec3 light_;
  bool flat_;
};

/// Corners of a box; corner k has the upper x, y, z for the bits 1, 2, 4 of k.
[[nodiscard]] std::array<Vec3, 8> corners(const Box& box);

/// A triangle on the page, in pixels of its panel.
struct Facet {
  std::array<Seen, 3> corners = {};
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
