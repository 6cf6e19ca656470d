/// \file
/// Two proven bounds of the distance of two triangles, from a pair of features that may be the
/// nearest. In doubles, and again in numbers of twice their precision.
///
/// Let u be the unit of the numbers: each operation is off by u times its result at most. Let S be
/// the largest coordinate of the corners relative to one of them, as they are stored here: they are
/// off by u S on an axis at most (doubles: one subtraction; pairs of doubles: none). Both bounds
/// are proofs whatever features were guessed, and whatever rounding made the points and the
/// direction.
///
/// Lower. For any direction n the distance is at least g / |n|, where g is the least n.w of corners
/// w of b less the greatest n.v of corners v of a. Products and sums round three times, corners
/// once: n.w is off by 4.01 u |n|_1 S, and so is n.v; their difference, at most 2.01 |n|_1 S,
/// rounds by 2.02 u |n|_1 S: below 10.1 u |n|_1 S in all. 12 u |n|_1 S is taken off; its own
/// roundings are covered by the rest. |n| rounds by 2.5 u (three in the square, and one), the
/// subtraction and the quotient by 2: a factor of 1 - 8 u covers these and itself.
///
/// Upper. A point P + s E + t F, s, t >= 0, s + t <= 1 + u, is off from a point of the triangle, on
/// an axis in units of u S, by: P 1; E and F each 4 (two corners, and a difference of at most 2 S),
/// their products with s and t 2, but s + t <= 1, so together 6; two sums, which are within the
/// triangle's box, 1 each; s + t beyond 1, 2: below 11.1. Twice that, and 2 for the difference of
/// the two points: 24.3, times sqrt(3): below 42.2. Their distance, at most 2 sqrt(3) S, rounds by
/// 2.5 u: 8.7, and the last sum by 3.6: below 55.
///
/// Underflow. S is in [2^-100, 2^101], by a power of two where need be, in which coordinates lose
/// 2^-1074 at most. Products and their low parts lose 2^-1074 each: beside u S >= 2^-202 that is
/// nothing where they are lengths, nor where they are squares, whose roots are off by 2^-535. A
/// direction counts only if its largest coordinate is at least 2^-400: then 12 u |n|_1 S is above
/// 2^-598.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/feature_pair.h"

#include <array>

namespace soms::detail {

/// What is taken off a support gap in units of u |n|_1 S, and added to a length in units of u S.
/// Largest errors seen by a search that climbs on them (48 starts, near, far, flat, thin and on
/// grids): in doubles 0.38 of the first and 0.11 of the second, in pairs of doubles 0.02 and 0.004.
inline constexpr double kLowerUnits = 12;
inline constexpr double kUpperUnits = 56;

static_assert(4.01 + 4.01 + 2.02 < kLowerUnits - 1);
static_assert(1.7321 * (2 * 11.1 + 2) + 8.7 + 3.6 < kUpperUnits - 1);

/// The units of both kinds of numbers.
inline constexpr double kUnitOfDouble = 0x1p-53;
inline constexpr double kUnitOfDoubleDouble = 0x1p-102;

/// Directions whose largest coordinate is out of this range prove nothing; quotients by 0 are.
inline constexpr double kLeastDirection = 0x1p-400;
inline constexpr double kMostDirection = 0x1p300;

/// Three coordinates of numbers T.
template <class T>
using Coordinates3 = std::array<T, 3>;

/// The corners of two triangles about the first of them: coordinates times 2^exponent are lengths.
template <class T>
struct AboutCorner {
  std::array<Coordinates3<T>, 6> corners;
  double reach = 0;  ///< the largest coordinate; 0 if all corners are equal
  int exponent = 0;

  AboutCorner(const Triangle& a, const Triangle& b);
};

/// A point of each triangle.
template <class T>
using EndPoints = std::array<Coordinates3<T>, 2>;

/// Bounds in units of the coordinates, and the points between which `upper` was measured.
template <class T>
struct Ends {
  T lower = 0;
  T upper = 0;
  EndPoints<T> points = {};
};

/// \pre  `place.reach` is above 0.
template <class T>
[[nodiscard]] Ends<T> ends(const AboutCorner<T>& place, const FeaturePair& features);

/// The points of `ends` alone.
template <class T>
[[nodiscard]] EndPoints<T> end_points(const AboutCorner<T>& place, const FeaturePair& features);

}  // namespace soms::detail
