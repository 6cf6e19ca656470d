/// \file
/// The least distance of two triangles in whole numbers: nothing is rounded.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/feature_pair.h"

#include <array>
#include <compare>
#include <cstddef>
#include <optional>

namespace soms::detail {

/// numerator / denominator * 4^exponent.
struct SquaredDistance {
  Integer numerator;
  Integer denominator = Integer(1);
  int exponent = 0;
};

[[nodiscard]] std::strong_ordering compare(const SquaredDistance& a, const SquaredDistance& b);

/// How the distance stands to `distance`, which is not negative, but may be infinite.
[[nodiscard]] std::strong_ordering compare(const SquaredDistance& a, double distance);

/// The doubles next to the distance.
[[nodiscard]] Bracket bracket(const SquaredDistance& squared);

/// A vector of whole numbers.
struct IntegerVec {
  Integer x;
  Integer y;
  Integer z;
};

[[nodiscard]] bool is_zero(const IntegerVec& v);
[[nodiscard]] IntegerVec operator-(const IntegerVec& a, const IntegerVec& b);
[[nodiscard]] IntegerVec operator*(const IntegerVec& a, const Integer& s);
[[nodiscard]] Integer dot(const IntegerVec& a, const IntegerVec& b);
[[nodiscard]] IntegerVec cross(const IntegerVec& a, const IntegerVec& b);

/// Two triangles on a common grid.
///
/// What proves a distance. If p of one triangle and q of the other are such that no point of the
/// first has a greater product with n = q - p than p, and none of the second a smaller one than q,
/// then the slab between them parts the triangles, and |n| is their distance. Conversely a shortest
/// segment has this property, and its ends are within features that are a pair of `kFeaturePairs`,
/// at right angles to both. So the distance is that of any pair of features whose feet lie on them
/// and whose direction has this property: one pair is proved without a look at the others.
class ExactPair {
 public:
  /// \pre Coordinates are finite.
  ExactPair(const Triangle& a, const Triangle& b);

  /// The squared distance of the triangles if a shortest segment, of length above 0, runs between
  /// these features; else nothing.
  [[nodiscard]] std::optional<SquaredDistance> squared_distance(const FeaturePair& features) const;

  /// A corner in units of the grid: triangle 0 or 1, corner 0 to 2.
  [[nodiscard]] const IntegerVec& at(std::size_t triangle, std::size_t corner) const {
    return corners_[3 * triangle + corner];
  }

  /// The grid's unit is 2^exponent.
  [[nodiscard]] int exponent() const { return exponent_; }

 private:
  using Found = std::optional<SquaredDistance>;

  [[nodiscard]] Found of_corners(const FeaturePair& features) const;
  [[nodiscard]] Found of_corner_and_edge(const FeaturePair& features, std::size_t corner_of) const;
  [[nodiscard]] Found of_corner_and_face(const FeaturePair& features, std::size_t corner_of) const;
  [[nodiscard]] Found of_edges(const FeaturePair& features) const;

  /// True if no corner is between the planes across `n` through the features; n points from
  /// triangle `from` to the other, `turned` says that its opposite does.
  [[nodiscard]] bool parts(const IntegerVec& n, const FeaturePair& features, std::size_t from,
                           bool turned) const;

  std::array<IntegerVec, 6> corners_;
  int exponent_ = 0;
};

/// The pair of features that a shortest segment joins, and its squared length.
struct ExactDistance {
  FeaturePair features = {};
  SquaredDistance squared;
};

/// The least distance of two triangles that share no point; `guess` is tried first, or is {0, 0}.
[[nodiscard]] ExactDistance exact_distance(const ExactPair& pair, const FeaturePair& guess);

}  // namespace soms::detail
