#include "soms/geometry/detail/point_to_triangle.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/distance_ends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace soms::detail {

namespace {

/// What is added to a length for an error on each axis: sqrt(3), rounded up.
constexpr double kOfAxes = 1.75;

using std::sqrt;

template <class T>
T length(const std::array<T, 3>& v) {
  return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// The length of a way that has one coordinate other than 0, or none.
std::optional<DoubleDouble> along_one_axis(const std::array<DoubleDouble, 3>& way) {
  DoubleDouble only;
  for (const DoubleDouble& x : way) {
    if (x == DoubleDouble{}) {
      continue;
    }
    if (only.high != 0) {
      return std::nullopt;
    }
    only = x.high < 0 ? -x : x;
  }
  return only;
}

TriangleFeature kind_of(Feature feature) {
  return feature == kFace             ? TriangleFeature::face
         : corner_count(feature) == 2 ? TriangleFeature::edge
                                      : TriangleFeature::vertex;
}

}  // namespace

PointToTriangle::PointToTriangle(const Vec3& point, const Triangle& triangle)
    : point_(point), triangle_(triangle), stage_(Stage::doubles) {
  const PlainArithmetic plain;
  found_ = find_feature(point, triangle);
  if (found_.proved()) {
    const double length_of_way = length(way_to<double>(point, triangle, found_.feature));
    const double error =
        kUnitOfDouble * (kOfAxes * found_.error + 8 * length_of_way) * (1 + 0x1p-20);
    lower_ = std::max(length_of_way - error, 0.0);
    upper_ = length_of_way + error;
    return;
  }
  // No second stage: what rounding leaves open is mostly a tie.
  stage_ = Stage::double_doubles;
  const AboutCorner<double> place(triangle, {point, point, point});
  if (place.reach == 0) {
    return;  // all four are one point
  }
  const Ends<double> found = ends(place, {found_.guess, 1});
  // Powers of two, but that small numbers lose what is below the least of them.
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  lower_ = std::max(std::ldexp(found.lower, place.exponent) - kLeast, 0.0);
  upper_ = std::ldexp(found.upper, place.exponent) + kLeast;
}

Bracket PointToTriangle::bounds() const {
  return {below(lower_), above(upper_)};
}

ExactPoint PointToTriangle::decide() {
  ExactPoint exact(point_, triangle_, found_.guess);
  if (!exact_.known()) {
    exact_ = PackedDistance(exact.squared());
    found_.feature = exact.feature();
  }
  return exact;
}

SquaredDistance PointToTriangle::squared() {
  return exact_.known() ? exact_.unpacked() : decide().squared();
}

void PointToTriangle::refine_way() {
  stage_ = Stage::double_doubles;
  if (const auto way = aligned_way(point_, triangle_, found_.feature)) {
    way_ = *way;
    found_.error = 0;
    if (const std::optional<DoubleDouble> whole = along_one_axis(way_)) {
      lower_ = *whole;
      upper_ = *whole;
      return;
    }
  } else {
    way_ = way_to<DoubleDouble>(point_, triangle_, found_.feature);
  }
  const DoubleDouble whole = length(way_);
  const DoubleDouble error =
      kUnitOfDoubleDouble * (kOfAxes * found_.error + 8 * whole.high) * (1 + 0x1p-20);
  lower_ = std::max(lower_, whole - error);
  upper_ = std::min(upper_, whole + error);
}

void PointToTriangle::refine() {
  if (stage_ == Stage::doubles) {
    refine_way();
    return;
  }
  stage_ = Stage::exact;
  const Bracket found = bracket(squared());
  lower_ = found.lower;
  upper_ = found.upper;
}

bool PointToTriangle::has_features_of(const PointToTriangle& other) const {
  return found_.proved() && other.found_.proved() &&
         same_corners(triangle_, found_.feature, other.triangle_, other.found_.feature);
}

std::strong_ordering PointToTriangle::compare_exactly(PointToTriangle& other) {
  return detail::compare(squared(), other.squared());
}

std::strong_ordering PointToTriangle::compare_exactly(double distance) {
  return detail::compare(squared(), distance);
}

std::strong_ordering PointToTriangle::compare(PointToTriangle& other) {
  return RefinedOrder<PointToTriangle>::compare(*this, other);
}

std::strong_ordering PointToTriangle::compare(double distance) {
  return RefinedOrder<PointToTriangle>::compare(*this, distance);
}

Bracket PointToTriangle::distance() {
  const PlainArithmetic plain;
  for (;;) {
    const bool enclosed = below(lower_) == below(upper_) && above(lower_) == above(upper_);
    if (enclosed || stage_ == Stage::exact) {
      return bounds();
    }
    refine();
  }
}

TriangleFeature PointToTriangle::feature() {
  const PlainArithmetic plain;
  if (!found_.proved() && !exact_.known()) {
    decide();
  }
  return kind_of(found_.feature);
}

/// w as it was found is off by `error` in units u, and the sum by 2 u of what it adds up. Where the
/// feature is level, so is the nearest point.
bool PointToTriangle::round_nearest(Vec3& rounded) {
  const Feature feature = found_.feature;
  const Vec3& first = corner(triangle_, first_corner(feature));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_level(triangle_, feature, axis)) {
      rounded[axis] = first[axis] + 0.0;
      continue;
    }
    const DoubleDouble x = way_[axis] + point_[axis];
    const double error = kUnitOfDoubleDouble *
                         (found_.error + 2 * (std::abs(way_[axis].high) + std::abs(point_[axis]))) *
                         (1 + 0x1p-20);
    const double up = (next_above(x.high) - x.high) / 2;
    const double down = (x.high - next_below(x.high)) / 2;
    if (!(x.low + error < up * (1 - 0x1p-20) && error - x.low < down * (1 - 0x1p-20))) {
      return false;
    }
    rounded[axis] = x.high + 0.0;
  }
  return true;
}

Vec3 PointToTriangle::nearest() {
  const PlainArithmetic plain;
  if (!found_.proved() && !exact_.known()) {
    decide();
  }
  if (corner_count(found_.feature) == 1) {
    const Vec3& v = corner(triangle_, first_corner(found_.feature));
    return {v.x + 0.0, v.y + 0.0, v.z + 0.0};
  }
  if (exact_.known()) {
    return decide().nearest();
  }
  if (stage_ == Stage::doubles) {
    refine_way();
  }
  Vec3 rounded;
  return round_nearest(rounded) ? rounded : decide().nearest();
}

}  // namespace soms::detail
