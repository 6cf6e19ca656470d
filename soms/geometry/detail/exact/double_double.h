/// \file
/// Numbers of twice the precision: unevaluated sums of two doubles.
#pragma once

#include "soms/base/portable.h"

#include <cmath>
#include <cstdint>

namespace soms::detail {

/// high + low, with high the double nearest to the sum.
///
/// Sum, difference, product, quotient and square root are within 2^-102 of their values,
/// relatively, where nothing over- or underflows (Joldes, Muller and Popescu 2017 prove 3, 3, 5 and
/// 15 u^2 for these forms of the first four, u = 2^-53; the square root is `sqrt`'s).
struct DoubleDouble {
  double high = 0;
  double low = 0;

  constexpr DoubleDouble() = default;

  // NOLINTNEXTLINE(google-explicit-constructor): a double is one of these numbers
  constexpr DoubleDouble(double x) : high(x) {}

  constexpr DoubleDouble(double h, double l) : high(h), low(l) {}

  [[nodiscard]] constexpr bool operator==(const DoubleDouble&) const = default;
};

/// a + b without error. \source Knuth; Moller 1965
[[nodiscard]] constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a + b without error, where |a| >= |b| or a is 0. \source Dekker 1971
[[nodiscard]] constexpr DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a b without error, where nothing over- or underflows. No fused multiply-add: where a product
/// underflows, that has other bits. \source Veltkamp 1968, Dekker 1971
[[nodiscard]] constexpr DoubleDouble two_product(double a, double b) {
  constexpr double kSplit = 0x1p27 + 1;
  const double product = a * b;
  const double a_scaled = kSplit * a;
  const double a_high = a_scaled - (a_scaled - a);
  const double a_low = a - a_high;
  const double b_scaled = kSplit * b;
  const double b_high = b_scaled - (b_scaled - b);
  const double b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

[[nodiscard]] constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble sum = quick_two_sum(high.high, high.low + low.high);
  return quick_two_sum(sum.high, low.low + sum.low);
}

[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

[[nodiscard]] constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = two_product(a.high, b.high);
  return quick_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

[[nodiscard]] constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  return quick_two_sum(first, rest.high / b.high);
}

[[nodiscard]] constexpr bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

[[nodiscard]] constexpr bool operator>(const DoubleDouble& a, const DoubleDouble& b) {
  return b < a;
}

/// One step of Newton's from the double next to it: off by (2^-53)^2 / 2 and the rounding of the
/// difference, 3 u^2 of it. 0 for numbers that are not above 0.
[[nodiscard]] inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (!(a.high > 0)) {
    return {};
  }
  const double first = std::sqrt(a.high);
  const DoubleDouble rest = a - two_product(first, first);
  return quick_two_sum(first, rest.high / (2 * first));
}

/// The least double above a finite one, as std::nextafter finds it, by the order of the bits.
[[nodiscard]] constexpr double next_above(double x) {
  const auto bits = bit_cast<std::int64_t>(x + 0.0);  // of -0 those of 0
  return bit_cast<double>(bits + (bits >= 0 ? 1 : -1));
}

/// The largest double below a finite one.
[[nodiscard]] constexpr double next_below(double x) {
  return -next_above(-x);
}

/// The largest double that is not above x.
[[nodiscard]] constexpr double below(const DoubleDouble& x) {
  return x.low < 0 ? next_below(x.high) : x.high;
}

/// The least double that is not below it.
[[nodiscard]] constexpr double above(const DoubleDouble& x) {
  return x.low > 0 ? next_above(x.high) : x.high;
}

}  // namespace soms::detail
