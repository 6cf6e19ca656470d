/// \file
/// On which side of a plane, or of a line in the plane, does a point lie? Answered without rounding
/// error.
#pragma once

#include "soms/base/vector.h"
#include "soms/base/words.h"

namespace soms {

/// Sign of a quantity that was decided exactly.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

/// Side of the plane through `a`, `b`, `c` on which `d` lies.
///
/// `positive` if `a`, `b`, `c` turn counter-clockwise when seen from `d`; `zero` only if all four
/// are exactly coplanar. Swapping two arguments flips the sign; an even permutation keeps it.
///
/// \shape   Four points, all in one length unit and one frame.
/// \pre     Coordinates are finite and of magnitude at most 2^300 (checked when meshes are posed).
/// \errors  None but memory: exact however small or nearly coplanar the input is.
/// \cost    About 40 flops; near-coplanar inputs fall back to exact arithmetic, far slower.
/// \source  Shewchuk 1997, Adaptive Precision Floating-Point Arithmetic, section 4.3.
[[nodiscard]] Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The coordinate plane in which a planar orientation is taken.
enum class Projection { xy, yz, zx };

template <>
inline constexpr auto kWords<Projection> = words("Projection",
                                                 "Which plane a triangle is projected onto.", "xy",
                                                 "yz", "zx");

/// Turn of `a`, `b`, `c` after dropping one coordinate: `positive` if counter-clockwise in the
/// plane (first, second) of `plane`, `zero` only if the projected points are exactly collinear.
/// \pre     As for `orientation`.
/// \source  Shewchuk 1997, section 4.2.
[[nodiscard]] Sign orientation2d(const Vec3& a, const Vec3& b, const Vec3& c, Projection plane);

}  // namespace soms
