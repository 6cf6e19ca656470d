/// \file
/// The exact steps behind `orientation`: slower twins that never round.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/orientation.h"

#include <optional>

namespace soms::detail {

/// Orientation in 192-bit integers, when the four coordinates of each axis are multiples of a power
/// of two that is at least 2^-59 times the largest of them; else nothing. Exact where it answers:
/// floats, grids and points that lie close together, which is where zeros come from.
[[nodiscard]] std::optional<Sign> orientation_grid(const Vec3& a, const Vec3& b, const Vec3& c,
                                                   const Vec3& d);

/// Orientation by adding the 24 products of the determinant in one wide fixed-point number. Exact
/// for all finite doubles, whatever their exponents; allocates nothing.
[[nodiscard]] Sign orientation_wide(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Orientation without a filter: shortcuts for plain zeros, then the grid, then the wide number.
[[nodiscard]] Sign orientation_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Planar orientation without a filter.
[[nodiscard]] Sign orientation2d_exact(const Vec3& a, const Vec3& b, const Vec3& c,
                                       Projection plane);

/// `fraction * 2^exponent`: also numbers beyond the range of doubles.
struct ScaledNumber {
  double fraction = 0;
  int exponent = 0;
};

/// The determinant whose sign `orientation` gives, right to 2^-51 of itself.
[[nodiscard]] ScaledNumber determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same for `orientation2d`.
[[nodiscard]] ScaledNumber determinant2d(const Vec3& a, const Vec3& b, const Vec3& c,
                                         Projection plane);

}  // namespace soms::detail
