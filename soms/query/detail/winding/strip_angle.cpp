#include "soms/query/detail/winding/strip_angle.h"

#include "soms/base/double_limits.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/exact/predicates.h"
#include "soms/query/detail/parity/triangle_crossing.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

// Constants of the proof in strip_angle.h.
constexpr double kImaginaryError = 44 * kRoundingUnit;
constexpr double kErrorOfWide = 80 * kRoundingUnit;  // turns, where |z| is at least kWide
constexpr double kErrorOfNarrow =
    11 * kRoundingUnit;  // turns, times |z|, where it is at least kNarrow
constexpr double kWide = 0.125;
constexpr double kNarrow = 0x1p-10;
constexpr double kErrorOfPrecise = 0x1p-98;        // turns, times |z|
constexpr double kErrorOfRounded = kRoundingUnit;  // turns
static_assert(2 * 19.6 + 2 < 44);
static_assert((2 * 19.6 + 3) * (2 * 19.6 + 3) + (2 * 19.6 + 2) * (2 * 19.6 + 2) < 60 * 60);
static_assert(60 * kRoundingUnit / kNarrow < 0.01);  // asin x < 1.003 x
static_assert((60 * 1.003 + 2.24) / 6.283 < 11 - 0.8);
static_assert((60 * 1.003 / kWide + 2.24) / 6.283 < 80 - 1);
static_assert(60 * 0x1p-102 < 0x1p-96 && 0x1p-96 / kLeastOfStrip < 0.01);
static_assert(1.003 * 0x1p-96 / 6.283 < kErrorOfPrecise * 0.7);
static_assert((1 + 2.24) * kRoundingUnit / 6.283 < kErrorOfRounded * 0.7);

/// Below, squares lose bits to underflow.
constexpr double kTiny = 0x1p-400;
constexpr double kLarger = 0x1p700;

/// What is across the axis, over |a|, below which h is nothing beside it.
constexpr double kThin = 0x1p-110;

double difference(double a, double b, double /*like*/) {
  return a - b;
}

DoubleDouble difference(double a, double b, const DoubleDouble& /*like*/) {
  return two_sum(a, -b);
}

double rounded(double x) {
  return x;
}

double rounded(const DoubleDouble& x) {
  return x.high;
}

double largest(double x, double y) {
  return std::max(std::abs(x), std::abs(y));
}

/// A corner that is all but straight against d.
template <class Real>
SeenCornerOf<Real> seen_against(const Real& first, const Real& second) {
  using std::sqrt;
  if (rounded(first) == 0 && rounded(second) == 0) {
    // It is taken as one beside it, as rays are.
    return {0, -1, 0};
  }
  const double larger = largest(rounded(first), rounded(second)) < kTiny ? kLarger : 1;
  const Real x = first * Real(larger);
  const Real y = second * Real(larger);
  const Real unit = Real(1) / sqrt(x * x + y * y);
  return {0, x * unit, y * unit};
}

template <class Real>
SeenCornerOf<Real> seen_from(const Vec3& corner, const Vec3& point,
                             const StripDirection& direction) {
  using std::sqrt;
  const std::size_t i = direction.axis;
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  Real along = difference(corner[i], point[i], Real(0)) * Real(direction.sign);
  Real first = difference(corner[j], point[j], Real(0));
  Real second = difference(corner[k], point[k], Real(0));
  if (largest(rounded(along), largest(rounded(first), rounded(second))) < kTiny) [[unlikely]] {
    along = along * Real(kLarger);
    first = first * Real(kLarger);
    second = second * Real(kLarger);
  }
  const Real square = first * first + second * second;
  const Real length = sqrt(along * along + square);
  if (rounded(along) < 0 && largest(rounded(first), rounded(second)) <= kThin * rounded(length))
      [[unlikely]] {
    return seen_against(first, second);
  }
  const Real sum = length + (rounded(along) < 0 ? -along : along);
  if (rounded(sum) == 0) {
    return {};
  }
  const Real height = rounded(along) < 0 ? square / sum : sum;
  const Real unit = Real(1) / sqrt(Real(2) * length * height);
  return {height * unit, first * unit, second * unit};
}

/// z of the proof.
template <class Real>
struct Product {
  Product(const SeenCornerOf<Real>& a, const SeenCornerOf<Real>& b, const StripDirection& direction)
      : re(a.along * b.along + (a.first * b.first + a.second * b.second)),
        im((a.first * b.second - a.second * b.first) * Real(direction.sign)) {}

  Real re;
  Real im;
};

/// An edge and a point near it.
struct NearEdge {
  const Vec3& from;
  const Vec3& to;
  const Vec3& point;
  const StripDirection& direction;

  /// `im` with the sign that it surely has.
  [[nodiscard]] double with_sign(double im) const {
    Predicates predicates;
    const Sign side = side_of_ray(from, to, point, direction.axis, predicates);
    const double sign = side == Sign::negative ? -direction.sign : direction.sign;
    return im * sign > 0 ? im : std::copysign(0.0, sign);
  }

  [[nodiscard]] StripAngle precise() const {
    const Product<DoubleDouble> z(seen_from<DoubleDouble>(from, point, direction),
                                  seen_from<DoubleDouble>(to, point, direction), direction);
    const double re = z.re.high;
    const double im = re < 0 ? with_sign(z.im.high) : z.im.high;
    const double size = std::sqrt(re * re + im * im);
    if (size < kLeastOfStrip) {
      return {1, 0, 0.5};
    }
    return {re, im, kErrorOfPrecise / size + kErrorOfRounded};
  }
};

}  // namespace

SeenCorner seen_corner(const Vec3& corner, const Vec3& point, const StripDirection& direction) {
  return seen_from<double>(corner, point, direction);
}

StripAngle strip_angle(const Vec3& from, const SeenCorner& a, const Vec3& to, const SeenCorner& b,
                       const Vec3& point, const StripDirection& direction) {
  const NearEdge edge{from, to, point, direction};
  const Product<double> z(a, b, direction);
  const double square = z.re * z.re + z.im * z.im;
  if (square < kNarrow * kNarrow) [[unlikely]] {
    return edge.precise();
  }
  const double error = square >= kWide * kWide ? kErrorOfWide : kErrorOfNarrow / std::sqrt(square);
  const bool unsure = z.re < 0 && std::abs(z.im) <= kImaginaryError;
  return {z.re, unsure ? edge.with_sign(z.im) : z.im, error};
}

}  // namespace soms::detail
