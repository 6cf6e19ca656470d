/// \file
/// A quick proof that two features are the nearest of two triangles.
///
/// Features are the nearest if their feet lie on them, and no other corner of the triangles is
/// between the planes through them across the direction n of a shortest segment (exact_distance.h).
/// Here all that is calculated in doubles, and must hold by more than rounding.
///
/// Let u = 2^-53 and |.| the largest coordinate. Differences e, f, r, w of corners are off by u of
/// each coordinate. In units of u times the product of the lengths that they are made of:
///   r.e: coordinates 2, product and sums 3, three terms: 15.
///   n = e x f, at most 2 |e| |f|: terms 3 each, their difference 2: 8.1.
///   n = r (e.e) - e (r.e), at most 6 |r| |e|^2: terms 3 + 15 + 2.1 and the same, and 6: below 50.
///   n.w: for n = r 15; for e x f 3 (8.1 + 2 * 4.1) < 49; else 3 (50 + 6 * 4.1) < 224.
///   (x x y).(e x f): 3 (2 * 8.1 + 2 * 8.1 + 4 * 3.1) < 135; a difference of two, twice that and 12
///   for itself: below 282.
/// Each must exceed 2^9 u of its lengths, which are rounded up no more than 2^-40 by their product.
///
/// Or a product n.w with n = e x f or n = r is 0 without doubt: where each of the products that it
/// is the sum of has a factor 0. Differences of doubles are 0 only where these are equal. So it is
/// with edges and faces along the axes. Only there do corners often lie in one plane.
///
/// Lengths are in [2^-150, 2^150], and at most four are multiplied, so nothing overflows. A product
/// that underflows is off by 2^-1074, and later multiplied by the same lengths as what it stands
/// beside: nothing beside 2^-44 of two or more lengths, 2^-344 for two.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/feature_pair.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

/// As a share of the product of lengths: what counts as surely above 0.
inline constexpr double kSureShare = 0x1p-44;

static_assert(282 * 0x1p-53 * (1 + 0x1p-40) < kSureShare);

/// The largest coordinate of a vector; NaN, which is above nothing, where products of four such
/// lengths might leave the range of doubles.
[[nodiscard]] inline double safe_length(const Vec3& v) {
  constexpr double kLeastLength = 0x1p-150;
  constexpr double kMostLength = 0x1p150;
  const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return most >= kLeastLength && most <= kMostLength ? most : std::nan("");
}

struct FeatureProof {
  /// A shortest segment joins the insides of these features.
  bool nearest = false;
  /// And it is the only one, and edges, or those of a face, are not so nearly parallel that its
  /// ends are hard to find.
  bool steady = false;
};

/// All false for contact, for most ties, and where doubles cannot tell.
/// \pre Coordinates are finite and of magnitude at most 2^300.
[[nodiscard]] FeatureProof prove(const Triangle& a, const Triangle& b, const FeaturePair& features);

/// The determinant of three vectors is 0 without doubt. \pre Entries are differences of doubles.
[[nodiscard]] bool surely_coplanar(const Vec3& e, const Vec3& f, const Vec3& w);

}  // namespace soms::detail
