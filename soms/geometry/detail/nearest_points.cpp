#include "soms/geometry/detail/nearest_points.h"

#include "soms/geometry/detail/crossing.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/leading_part.h"
#include "soms/geometry/detail/feature_proof.h"
#include "soms/geometry/detail/nearest_guess.h"
#include "soms/geometry/detail/parts/common_corners.h"
#include "soms/geometry/triangle_overlap.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace soms::detail {

namespace {

using Point = std::array<DoubleDouble, 3>;

DoubleDouble scaled(const DoubleDouble& x, int exponent) {
  return {std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
}

/// The quotient, off by 2^-100 of itself, times 2^exponent.
DoubleDouble quotient(const Integer& above, const Integer& below, int exponent) {
  const LeadingPart a = leading_part(above);
  const LeadingPart b = leading_part(below);
  return scaled(a.value / b.value, a.exponent - b.exponent + exponent);
}

Point plus(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The point at `share` of the segment from corner to corner.
Point between(const Triangle& t, const Share& share) {
  const Vec3& begin = corner(t, share.begin);
  const Vec3& end = corner(t, share.end);
  const DoubleDouble s = quotient(share.part, share.whole, 0);
  Point result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result[axis] = begin[axis] + s * two_sum(end[axis], -begin[axis]);
  }
  return result;
}

/// From triangle to triangle: n h / n.n, h the gap along n.
Point offset(const ExactPair& pair, const IntegerVec& n, const FeaturePair& features) {
  const Integer gap =
      dot(n, pair.at(1, first_corner(features[1])) - pair.at(0, first_corner(features[0])));
  const Integer square = dot(n, n);
  return {quotient(n.x * gap, square, pair.exponent()),
          quotient(n.y * gap, square, pair.exponent()),
          quotient(n.z * gap, square, pair.exponent())};
}

/// Means, rounded.
struct Mean {
  Point sum = {};

  void add(const Point& p) { sum = plus(sum, p); }

  [[nodiscard]] Vec3 value(double count) const {
    return {(sum[0] / count).high, (sum[1] / count).high, (sum[2] / count).high};
  }
};

}  // namespace

std::array<Vec3, 2> in_world(const EndPoints<DoubleDouble>& points, int exponent,
                             const Triangle& a) {
  std::array<Vec3, 2> result;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result[side][axis] = (scaled(points[side][axis], exponent) + a.a[axis]).high;
    }
  }
  return result;
}

std::array<Vec3, 2> nearest_points(const Triangle& a, const Triangle& b) {
  const FeaturePair guess = guess_features(a, b);
  if (prove(a, b, guess).steady) {
    const AboutCorner<DoubleDouble> place(a, b);
    return in_world(end_points(place, guess), place.exponent, a);
  }
  if (const std::optional<Vec3> middle = crossing_middle(a, b)) {
    return {*middle, *middle};
  }
  const ExactPair pair(a, b);
  std::optional<IntegerVec> n;
  Point across = {};
  FeaturePair features = {};
  if (!triangles_overlap(a, b)) {
    features = exact_distance(pair, guess).features;
    n = direction(pair, features);
    across = offset(pair, *n, features);
  }
  const std::vector<CommonCorner> corners = common_corners(pair, features, n);
  Mean mean_a;
  Mean mean_b;
  for (const CommonCorner& c : corners) {
    if (c.on_a.whole.sign() != 0) {
      mean_a.add(between(a, c.on_a));
      mean_b.add(c.on_b.whole.sign() != 0 ? between(b, c.on_b) : plus(between(a, c.on_a), across));
    } else {
      mean_a.add(minus(between(b, c.on_b), across));
      mean_b.add(between(b, c.on_b));
    }
  }
  const auto count = static_cast<double>(corners.size());
  const Vec3 middle = mean_a.value(count);
  return {middle, n ? mean_b.value(count) : middle};
}

}  // namespace soms::detail
