#include "soms/geometry/detail/ray_plane.h"

#include "soms/geometry/detail/exact/double_double3.h"
#include "soms/geometry/detail/exact/power_of_two.h"
#include "soms/geometry/detail/exact/predicates.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// Smaller parts of a direction, and smaller or larger results, are left to whole numbers: nothing
/// underflows between these.
constexpr double kLeastPart = 0x1p-400;
constexpr double kLeastResult = 0x1p-900;
constexpr double kMostResult = 0x1p900;

constexpr double kQuotientRounding = 0x1p-50;
constexpr double kQuotientUnderflow = 0x1p-1000;
static_assert(4 * kRoundingUnit < kQuotientRounding);

constexpr double kRoundingOfTerms = 0x1p-98;
static_assert(6 * 0x1p-102 * (1 + 0x1p-40) < kRoundingOfTerms);

constexpr double kMostRelative = 0x1p-62;

Vec3 magnitudes(const Vec3& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// The double nearest to x, which is off by less than `error`; nothing where that is not sure.
std::optional<double> sure_nearest(const DoubleDouble& x, double error) {
  if (!(std::abs(x.high) > kLeastResult) || x.high + (x.low + 2 * error) != x.high ||
      x.high + (x.low - 2 * error) != x.high) {
    return std::nullopt;
  }
  return x.high;
}

}  // namespace

ScaledDirection::ScaledDirection(const RayLine& line) {
  const Vec3& to = line.ahead;
  part = line.segment ? difference(to, line.origin) : DoubleDouble3{to.x, to.y, to.z};
  const double largest =
      std::max({std::abs(part[0].high), std::abs(part[1].high), std::abs(part[2].high)});
  if (largest == 0) {
    exact = false;
    return;
  }
  exponent = exponent_of(largest);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    DoubleDouble& p = part[axis];
    const DoubleDouble scaled{times_power_of_two(p.high, -exponent),
                              times_power_of_two(p.low, -exponent)};
    const auto kept = [](double x, double y) { return x == 0 || std::abs(y) >= kLeastPart; };
    exact = exact && kept(p.high, scaled.high) && kept(p.low, scaled.low);
    p = scaled;
    high[axis] = p.high;
  }
}

std::optional<TimeBounds> time_bounds(const RayLine& line, const ScaledDirection& direction,
                                      const Triangle& triangle) {
  if (!direction.exact) {
    return std::nullopt;
  }
  const Plane plane(triangle.a, triangle.b, triangle.c);
  const Vec3 w = line.origin - triangle.a;
  const double height = dot(plane.normal, w);
  const double steep = dot(plane.normal, direction.high);
  const double height_error = error_bound(plane, magnitudes(w));
  const double steep_error = 1.5 * error_bound(plane, magnitudes(direction.high));
  const double least_steep = std::abs(steep) - steep_error;
  if (!(least_steep > 0)) {
    return std::nullopt;
  }
  TimeBounds bounds;
  bounds.side = steep < 0 ? 1 : -1;
  const double most = (std::abs(height) + height_error) / least_steep;
  const double least = (std::abs(height) - height_error) / (std::abs(steep) + steep_error);
  bounds.upper = most * (1 + kQuotientRounding) + kQuotientUnderflow;
  bounds.lower = least > 0 ? least * (1 - kQuotientRounding) - kQuotientUnderflow : -bounds.upper;
  if ((height > 0) == (steep > 0)) {
    bounds = {-bounds.upper, -bounds.lower, bounds.side};
  }
  return bounds;
}

std::optional<PlaneHit> plane_hit(const RayLine& line, const ScaledDirection& direction,
                                  const Triangle& triangle) {
  if (!direction.exact) {
    return std::nullopt;
  }
  const Plane plane(triangle.a, triangle.b, triangle.c);
  const DoubleDouble3 u = difference(triangle.b, triangle.a);
  const DoubleDouble3 v = difference(triangle.c, triangle.a);
  const DoubleDouble3 from = difference(triangle.a, line.origin);
  const DoubleDouble3 normal = cross(u, v);
  const DoubleDouble height = dot(normal, from);
  const DoubleDouble steep = dot(normal, direction.part);
  const double height_error =
      kRoundingOfTerms *
          dot(plane.magnitude, magnitudes({from[0].high, from[1].high, from[2].high})) +
      kUnderflow;
  const double steep_error =
      kRoundingOfTerms * dot(plane.magnitude, magnitudes(direction.high)) + kUnderflow;
  const double relative =
      2 * (height_error / std::abs(height.high) + steep_error / std::abs(steep.high)) + 0x1p-101;
  if (!(relative < kMostRelative)) {
    return std::nullopt;
  }
  const DoubleDouble t = height / steep;
  const double error = std::abs(t.high) * relative * 2;
  const double in_units = times_power_of_two(t.high, -direction.exponent);
  if (!(std::abs(t.high) > kLeastResult && std::abs(t.high) < kMostResult &&
        std::abs(in_units) > kLeastResult && std::abs(in_units) < kMostResult &&
        std::abs(t.low) > error)) {
    return std::nullopt;
  }
  PlaneHit hit;
  hit.side = steep.high < 0 ? 1 : -1;
  hit.t =
      t.low > 0 ? Bracket{in_units, next_above(in_units)} : Bracket{next_below(in_units), in_units};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const DoubleDouble& d = direction.part[axis];
    if (d.high == 0) {
      hit.point[axis] = line.origin[axis] + 0.0;
      continue;
    }
    const DoubleDouble way = t * d;
    const DoubleDouble x = way + line.origin[axis];
    const std::optional<double> nearest = sure_nearest(
        x, std::abs(way.high) * (2 * relative + 0x1p-100) + std::abs(x.high) * 0x1p-100);
    if (!nearest) {
      return std::nullopt;
    }
    hit.point[axis] = *nearest;
  }
  return hit;
}

}  // namespace soms::detail
