/// \file
/// Which corner, edge or face of a triangle is nearest to a point, and the way there, as far as
/// plain doubles can tell.
///
/// The nearest point of a triangle is a corner v exactly where no side of the triangle leads from v
/// toward the point p: with r = v - p, r.e >= 0 for both sides e from v. It is inside an edge e
/// from v exactly where 0 < -r.e < e.e and p is not on the inner side of the plane through e across
/// the triangle; else it is inside the face. Here all of that is calculated in doubles, and must
/// hold by more than rounding: by kSureShare of the product of its lengths (feature_proof.h, where
/// r.e and (x x y).(e x f) are bounded).
///
/// The way w from p to the nearest point. Let u be the unit of the numbers, 2^-53 or 2^-102, |.|
/// the largest coordinate. Differences e, r of corners are off by u of themselves.
///   Corner: w = r, off by u |r|.
///   Edge: g = r.e / e.e is within [-1, 0]. r.e and e.e are off by 15 u |r| |e| and 15 u |e|^2, and
///   e.e >= |e|^2: so g is off by 15.1 u |r| / |e| + 16.2 u, and w = r - e g by below
///   32 u (|r| + |e|), roundings of the product and the difference included.
///   Face: n = e x f with L = |e| |f| is off by 8.1 u L, n.r by 49 u L |r|, n.n by 140 u L^2. With
///   q = n.n / L^2 and a distance |n.r| / |n|_2 of at most 1.7321 |r|, w = n (n.r / n.n) is off by
///   49 u |r| / sqrt(q) for n.r, 243 u |r| / q for n.n, 15 u |r| / sqrt(q) for n, 6 u |r| for
///   roundings: below 2^9 u |r| / min(q, 1), and q must be 2^-20 at least, so that products of
///   errors are nothing.
/// Where the corners of the feature differ along as many axes as it has dimensions (a wall across
/// an axis, an edge along one, any corner), w is 0 along these and has the coordinates of r along
/// the others, without error: as sums of two doubles, differences of doubles are exact. The length
/// of w is off by sqrt(3) times that, and 4 u of itself. The largest coordinate of such a w is at
/// least 2^-48 of |r|, for an edge as p is outside of it by that, so its square does not underflow.
/// Lengths are within [2^-150, 2^150], so nothing over- or underflows that is not nothing beside u
/// times what it is added to.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/feature_pair.h"

#include <array>
#include <optional>

namespace soms::detail {

/// What was found of a point and a triangle.
struct PointFeature {
  Feature feature = 0;  ///< of the triangle; 0 if it is not proved
  Feature guess = 1;    ///< one that is nearest, or nearly so
  double error = 0;     ///< of the way's coordinates in units u of the numbers it is calculated in

  [[nodiscard]] bool proved() const { return feature != 0; }
};

/// \pre Coordinates are finite and of magnitude at most 2^300.
[[nodiscard]] PointFeature find_feature(const Vec3& point, const Triangle& triangle);

/// Three coordinates of the way from the point to a proved feature, T being double or DoubleDouble.
template <class T>
[[nodiscard]] std::array<T, 3> way_to(const Vec3& point, const Triangle& triangle, Feature feature);

/// The way to a proved feature, without error, if it lies along axes as the proof above says.
[[nodiscard]] std::optional<std::array<DoubleDouble, 3>> aligned_way(const Vec3& point,
                                                                     const Triangle& triangle,
                                                                     Feature feature);

}  // namespace soms::detail
