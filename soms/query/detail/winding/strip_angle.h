/// \file
/// Half the solid angle of a strip without end: what an edge of a surface's boundary adds to the
/// winding number.
///
/// The strip of the edge from A to B is the set of all x + s d for x on the edge and s >= 0, along
/// an axis d of the world. With a = A - p and b = B - p, its solid angle from p is twice the
/// argument of
///   z = (|a| + a.d) (|b| + b.d) + a'.b' + i (a' x b'),
/// where a' and b' are the parts across d: the formula of Van Oosterom and Strackee 1983 for a
/// triangle whose third corner is far away along d. It is a product: with the pair
///   S(a) = (|a| + a.d, a') / sqrt(2 |a| (|a| + a.d)),
/// of length 1, z is S(a).S(b) + i S'(a) x S'(b). So each corner takes its square roots once,
/// however many edges it has. For a.d < 0, where |a| + a.d would cancel, it is |a'|^2 / (|a| -
/// a.d). |z| is the cosine of half the angle between a and b: it is small only where p is near the
/// edge.
///
/// Rounding, in units of u = 2^-53, relative. a is off by 1 in each coordinate, |a| by 3.5, h = |a|
/// + a.d by 4.5, or by 9.5 as a quotient, 2 |a| h by 14, one over its square root by 9, and the
/// entries of S(a) by 19.5 and 11. So z is off by 2 * 19.6 for S(a) and S(b) (Cauchy) and by 3 for
/// its own rounding on the real axis, by 39.2 + 2 on the other: |z| by less than 60. Its argument
/// is off by asin(60 u / |z|), by less than 60.2 u / |z| where |z| >= 2^-10, and a product of
/// AngleSum by 2.24 u: over 2 pi, below 11 u / |z| turns, and below 80 u where |z| >= 1/8. Where
/// |z| is less, all is done again with u = 2^-102 (double_double.h): z is off by 60 * 2^-102, the
/// argument by asin(2^-96 / |z|); rounding z to double turns it by less than 2^-53: over 2 pi,
/// below 2^-98 / |z| + 2^-53 turns.
///
/// Underflow. All of a is enlarged where it is small, so |a| is at least 2^-400. Straight against
/// d, where a' is below 2^-110 |a|, h is below 2^-109 |a'| and is taken as 0. Else squares of a'
/// are at least 2^-1020: where bits of them are lost, 2^-1074 of h's numerator, S(a) turns by
/// 2^-1074 / (|a'| |a|), less than 2^-160, and one over the root is a factor of the whole of S(a).
/// Products of S(a) and S(b) that underflow are nothing beside their errors.
///
/// At half a turn: where p is on the strip, z is negative, and the angle jumps. Which way p passes
/// it is decided exactly, in the way in which crossings of the ray against d are: so the two jump
/// together, and what they add up to does not. The sign of the imaginary part is set to that, by
/// which z gets nearer to its true value, if anything.
#pragma once

#include "soms/base/vector.h"

#include <cstddef>

namespace soms::detail {

/// A corner as seen from a point: S of the proof.
template <class Real>
struct SeenCornerOf {
  Real along = 0;
  Real first = 0;  ///< across d, on the axis after it
  Real second = 0;
};

using SeenCorner = SeenCornerOf<double>;

/// Where strips lead: along an axis (0 is x), toward greater coordinates (1) or lesser ones (-1).
struct StripDirection {
  std::size_t axis = 0;
  double sign = 1;
};

/// \pre All coordinates are within 2^300. Where corner and point are equal, all is 0.
[[nodiscard]] SeenCorner seen_corner(const Vec3& corner, const Vec3& point,
                                     const StripDirection& direction);

/// z of the proof.
struct StripAngle {
  double re = 1;
  double im = 0;
  double error = 0;  ///< of the argument as AngleSum adds it, in turns
};

/// Of |z| below this nothing is known of the argument but that it is in [-1/2, 1/2] turns: it is
/// taken as 0, and the error is 1/2. So near is a point at 1e-24 of its length from an edge.
inline constexpr double kLeastOfStrip = 0x1p-80;

/// The strip of the edge between two corners that are seen as `a` and `b`.
[[nodiscard]] StripAngle strip_angle(const Vec3& from, const SeenCorner& a, const Vec3& to,
                                     const SeenCorner& b, const Vec3& point,
                                     const StripDirection& direction);

}  // namespace soms::detail
