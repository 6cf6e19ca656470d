/// \file
/// The nearest point of a triangle to a point in whole numbers: nothing is rounded but what is
/// given out.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/feature_pair.h"

#include <cstddef>

namespace soms::detail {

/// The double nearest to above / below * 2^exponent, ties to even; 0 has no sign. \pre below > 0,
/// and the quotient is in the range of doubles.
[[nodiscard]] double nearest_double(const Integer& above, const Integer& below, int exponent);

/// A point and a triangle on a common grid. The conditions are those of point_feature.h; they hold
/// for triangles without area, too, of which no face is nearest.
class ExactPoint {
 public:
  /// `guess` is tried first. \pre Coordinates are finite.
  ExactPoint(const Vec3& point, const Triangle& triangle, Feature guess);

  /// A corner of the triangle if the nearest point is one, else an edge if it is on one, else the
  /// face.
  [[nodiscard]] Feature feature() const { return feature_; }

  [[nodiscard]] const SquaredDistance& squared() const { return squared_; }

  /// The nearest point, each coordinate rounded to the nearest double.
  [[nodiscard]] Vec3 nearest() const;

 private:
  [[nodiscard]] const IntegerVec& at(std::size_t i) const { return pair_.at(0, i); }

  [[nodiscard]] const IntegerVec& point() const { return pair_.at(1, 0); }

  [[nodiscard]] bool is_corner(std::size_t i) const;
  [[nodiscard]] bool is_edge(Feature edge) const;
  [[nodiscard]] bool is_inside() const;
  [[nodiscard]] bool is(Feature feature) const;
  [[nodiscard]] SquaredDistance measured() const;
  [[nodiscard]] IntegerVec normal() const;

  ExactPair pair_;  // with a triangle whose corners are the point
  Feature feature_ = 0;
  SquaredDistance squared_;
};

}  // namespace soms::detail
