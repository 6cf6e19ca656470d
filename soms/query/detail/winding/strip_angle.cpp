#include "soms/query/detail/winding/strip_angle.h"

#include "soms/geometry/detail/predicates.h"
#include "soms/query/detail/parity/triangle_crossing.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

constexpr double kUnit = 0x1p-53;

// Constants of the proof in strip_angle.h.
constexpr double kImaginaryError = 40 * kUnit;
constexpr double kErrorOfWide = 72 * kUnit;   // turns, where |z| is at least kWide
constexpr double kErrorOfNarrow = 10 * kUnit;  // turns, times |z|
constexpr double kWide = 0.125;
static_assert(2 * 18.1 + 2 < 40);
static_assert((2 * 18.1 + 3) * (2 * 18.1 + 3) + (2 * 18.1 + 2) * (2 * 18.1 + 2) < 55 * 55);
static_assert(55 * 0x1p-53 / kLeastOfStrip < 0.11);  // asin x < 1.003 x
static_assert((55 * 1.003 + 2.24) / 6.283 < 10 - 0.8);
static_assert((55 * 1.003 / kWide + 2.24) / 6.283 < 72 - 1);

/// Below, squares lose bits to underflow.
constexpr double kTiny = 0x1p-400;
constexpr double kLarger = 0x1p600;

}  // namespace

SeenCorner seen_corner(const Vec3& corner, const Vec3& point, const StripDirection& direction) {
  Vec3 v = corner - point;
  if (std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) < kTiny) [[unlikely]] {
    v = v * kLarger;
  }
  const double along = v[direction.axis] * direction.sign;
  double first = v[(direction.axis + 1) % 3];
  double second = v[(direction.axis + 2) % 3];
  double square = first * first + second * second;
  const double length = std::sqrt(along * along + square);
  if (along >= 0) {
    const double sum = length + along;
    if (sum == 0) {
      return {};
    }
    const double unit = 1 / std::sqrt(2 * length * sum);
    return {sum * unit, first * unit, second * unit};
  }
  if (first == 0 && second == 0) {
    // Straight against d, the corner is taken as one beside it, as rays are.
    return {0, -1, 0};
  }
  double larger = 1;
  if (std::max(std::abs(first), std::abs(second)) < kTiny) [[unlikely]] {
    larger = kLarger;
    first *= larger;
    second *= larger;
    square = first * first + second * second;
  }
  const double across = std::sqrt(square);
  const double sum = length - along;
  const double unit = 1 / std::sqrt(2 * length * sum);
  const double turn = sum * unit / across;
  return {across / larger * unit, first * turn, second * turn};
}

StripAngle strip_angle(const Vec3& from, const SeenCorner& a, const Vec3& to, const SeenCorner& b,
                       const Vec3& point, const StripDirection& direction) {
  StripAngle z;
  z.re = a.along * b.along + (a.first * b.first + a.second * b.second);
  z.im = (a.first * b.second - a.second * b.first) * direction.sign;
  const double square = z.re * z.re + z.im * z.im;
  if (square >= kWide * kWide) {
    z.error = kErrorOfWide;
  } else if (square >= kLeastOfStrip * kLeastOfStrip) {
    z.error = kErrorOfNarrow / std::sqrt(square);
  } else {
    return {1, 0, 0.5};
  }
  if (z.re < 0 && std::abs(z.im) <= kImaginaryError) {
    Predicates predicates;
    const Sign side = side_of_ray(from, to, point, direction.axis, predicates);
    const double sign = side == Sign::negative ? -direction.sign : direction.sign;
    z.im = z.im * sign > 0 ? z.im : std::copysign(0.0, sign);
  }
  return z;
}

}  // namespace soms::detail
