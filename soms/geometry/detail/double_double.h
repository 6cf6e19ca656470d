/// \file
/// Numbers of about 106 bits as unevaluated sums of two doubles: for lengths and ratios that are
/// given to people, never for signs.
#pragma once

#include "soms/base/vector.h"

namespace soms::detail {

/// The value `high + low`, where `high` is that sum rounded.
struct DoubleDouble {
  double high = 0;
  double low = 0;
};

/// The exact sum of two doubles. \source Knuth, The Art of Computer Programming 2, section 4.2.2.
[[nodiscard]] constexpr DoubleDouble sum(double a, double b) {
  const double s = a + b;
  const double v = s - a;
  return {s, (a - (s - v)) + (b - v)};
}

/// The exact product of two doubles, short of overflow and underflow.
/// \source Dekker 1971, A floating-point technique for extending the available precision.
[[nodiscard]] constexpr DoubleDouble product(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1;
  const double ca = kSplit * a;
  const double cb = kSplit * b;
  const double ah = ca - (ca - a);
  const double bh = cb - (cb - b);
  const double al = a - ah;
  const double bl = b - bh;
  const double p = a * b;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

[[nodiscard]] constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = sum(a.high, b.high);
  const DoubleDouble low = sum(a.low, b.low);
  const DoubleDouble once = sum(high.high, high.low + low.high);
  return sum(once.high, once.low + low.low);
}

[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

[[nodiscard]] constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble p = product(a.high, b.high);
  return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// A vector of such numbers.
struct WideVector {
  DoubleDouble x;
  DoubleDouble y;
  DoubleDouble z;
};

/// `scale * (to - from)`; exact, short of underflow, where `scale` is a power of two.
[[nodiscard]] constexpr WideVector difference(const Vec3& to, const Vec3& from, double scale) {
  const auto axis = [scale](double a, double b) {
    const DoubleDouble d = sum(a, -b);
    return DoubleDouble{d.high * scale, d.low * scale};
  };
  return {axis(to.x, from.x), axis(to.y, from.y), axis(to.z, from.z)};
}

[[nodiscard]] constexpr WideVector cross(const WideVector& a, const WideVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] constexpr DoubleDouble dot(const WideVector& a, const WideVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace soms::detail
