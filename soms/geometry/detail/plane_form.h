/// \file
/// Points and lines of a plane in whole numbers of any length.
///
/// A point that lies on the line of a form is moved by (e, e^2), 0 < e as small as need be
/// (Edelsbrunner and Muecke 1990): the same for all forms, so answers agree with one another.
#pragma once

#include "soms/geometry/detail/exact/integer.h"

namespace soms::detail {

/// The point (u / w, v / w) of the plane. w > 0.
struct PlanePoint {
  Integer u;
  Integer v;
  Integer w;
};

/// A linear form: its sign at a point tells on which side of a line the point lies.
struct PlaneForm {
  Integer u;
  Integer v;
  Integer w;

  /// Sign at a point: -1, 0 or 1.
  [[nodiscard]] int sign(const PlanePoint& p) const;

  /// Sign at the moved point: 0 only if the form is 0 everywhere.
  [[nodiscard]] int sign_beside(const PlanePoint& p) const;

  [[nodiscard]] bool is_zero() const;
};

/// A segment in the plane that parts cells, and its line.
struct PlaneCut {
  PlaneForm line;
  PlanePoint from;
  PlanePoint to;
};

}  // namespace soms::detail
