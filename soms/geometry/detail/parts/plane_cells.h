/// \file
/// A triangle cut into cells by others, in whole numbers: what decides where surfaces touch.
///
/// Everything is seen in the plane of one triangle t, along a coordinate axis k that is not
/// parallel to it. A point of the plane is given by its other two coordinates (u, v), in units of a
/// grid on which the corners of t lie, relative to a corner of t, as quotients (U / W, V / W) with
/// W > 0. The side of another triangle's plane, and the side of a projected edge, are linear forms
/// in (U, V, W): so nothing is rounded, and no number is longer than a product of two forms.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/exact/predicates.h"
#include "soms/geometry/detail/parts/convex_cell.h"
#include "soms/geometry/detail/plane_form.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace soms::detail {

/// Another triangle s as the plane of t sees it.
class SeenTriangle {
 public:
  /// The triangle has no area, so it neither parts space nor covers anything.
  [[nodiscard]] bool flat() const { return flat_; }

  [[nodiscard]] bool coplanar() const { return side_.is_zero(); }

  /// Appends the segments that it cuts the plane along.
  void append_cuts(std::vector<PlaneCut>& cuts) const;

  /// \pre Coplanar, and the point is in the interior of a cell that it cut.
  [[nodiscard]] bool covers(const PlanePoint& p) const;

  /// Whether the ray from the moved point, in the sense of axis k, crosses the triangle. Coplanar
  /// triangles are not crossed.
  [[nodiscard]] bool is_above(const PlanePoint& p) const;

 private:
  friend class CellPlane;

  /// Where edge i, from corner i to the next one, meets the plane.
  [[nodiscard]] PlanePoint crossing(std::size_t i) const;

  PlaneForm side_;                    // of the plane of s
  std::array<PlaneForm, 3> edge_;     // of the projected edges
  std::array<PlanePoint, 3> corner_;  // projected
  std::array<Integer, 3> height_;     // of the corners over the plane of t
  int turn_ = 0;                      // of the projected triangle; 0: it is a segment
  bool flat_ = false;
};

/// The plane of a triangle with area.
class CellPlane {
 public:
  /// Which axis to look along: the one most across the triangle, or the least so.
  enum class View { steep, shallow };

  /// Nothing for a triangle without area.
  [[nodiscard]] static std::optional<CellPlane> of(const Triangle& t, View view);

  [[nodiscard]] SeenTriangle seen(const Triangle& s) const;

  /// Calls `visit` with a point inside each cell that the cuts leave of the triangle, until it
  /// returns false. Returns false if it did.
  /// \cost Grows with the number of cells times that of the cuts.
  bool for_each_cell(std::span<const PlaneCut> cuts, const CellVisit& visit) const;

  /// The same in boxes of few cuts, which cut, too: large cells are visited more than once.
  /// \cost As `CellBoxes`.
  bool for_each_cell_in_boxes(std::span<const PlaneCut> cuts, const CellVisit& visit) const;

  /// The segment between two points of the plane, of which one is not above the other in the sense
  /// of axis k.
  [[nodiscard]] PlaneCut cut_between(const Vec3& p, const Vec3& q) const;

  /// False only if the segment between two points of the plane does not pass through the interior
  /// of the triangle.
  [[nodiscard]] bool may_part(const Vec3& p, const Vec3& q, Predicates& predicates) const;

  /// False only if a triangle, seen along axis k, does not cover the moved point to which a ray
  /// belongs.
  [[nodiscard]] bool may_cover(const Triangle& s, const Box& ray) const;

  /// True if no point of the triangle is above the plane, in the sense of axis k, so that no ray
  /// from it crosses the triangle.
  [[nodiscard]] bool has_below(const Triangle& s, Predicates& predicates) const;

  /// A box that holds the ray from a point of the triangle, in the sense of axis k.
  [[nodiscard]] Box ray_box(const PlanePoint& p) const;

 private:
  CellPlane(const Triangle& t, std::size_t axis);

  /// The whole triangle.
  [[nodiscard]] Cell whole() const;

  Triangle triangle_;
  std::size_t axis_;  // k
  int exponent_;      // of the grid's unit
  SeenTriangle own_;
};

}  // namespace soms::detail
