/// \file
/// Numbers m 2^e, which sums and products of doubles are: nothing is rounded.
#pragma once

#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/parts/odd.h"

#include <array>
#include <cstddef>
#include <utility>

namespace soms::reference::detail {

/// A whole number times a power of two.
class Dyadic {
 public:
  Dyadic() = default;

  explicit Dyadic(double value) {
    if (value != 0) {
      const soms::detail::Odd odd(value);
      number_ = soms::detail::Integer(odd.number);
      exponent_ = odd.exponent;
    }
  }

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const { return number_.sign(); }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.number_ * b.number_, a.exponent_ + b.exponent_};
  }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0 || b.sign() == 0) {
      return a.sign() == 0 ? b : a;
    }
    return a.exponent_ >= b.exponent_ ? Dyadic((a.number_ << shift(a, b)) + b.number_, b.exponent_)
                                      : Dyadic(a.number_ + (b.number_ << shift(b, a)), a.exponent_);
  }

  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) {
    return a + Dyadic(-b.number_, b.exponent_);
  }

  friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }

 private:
  Dyadic(soms::detail::Integer number, int exponent)
      : number_(std::move(number)), exponent_(exponent) {}

  /// \pre That of `a` is not the lesser exponent.
  static std::size_t shift(const Dyadic& a, const Dyadic& b) {
    return static_cast<std::size_t>(a.exponent_ - b.exponent_);
  }

  soms::detail::Integer number_;
  int exponent_ = 0;
};

/// A vector of them.
using DyadicVec = std::array<Dyadic, 3>;

/// The sum of coefficient k times t^k.
class Cubic {
 public:
  Cubic() = default;

  explicit Cubic(Dyadic constant, Dyadic linear = {}) {
    at_[0] = std::move(constant);
    at_[1] = std::move(linear);
  }

  [[nodiscard]] Dyadic operator()(const Dyadic& t) const {
    return ((at_[3] * t + at_[2]) * t + at_[1]) * t + at_[0];
  }

  /// Surely above 0 on [a, b]: all coefficients are in Bernstein's form there, three times each.
  [[nodiscard]] bool positive_on(const Dyadic& a, const Dyadic& b) const {
    const Dyadic two(2);
    const Dyadic three(3);
    const Dyadic h = b - a;
    const Dyadic c0 = three * (*this)(a);
    const Dyadic c1 = (at_[1] + a * (two * at_[2] + three * at_[3] * a)) * h;
    const Dyadic c2 = (at_[2] + three * at_[3] * a) * h * h;
    return c0.sign() > 0 && (c0 + c1).sign() > 0 && (c0 + two * c1 + c2).sign() > 0 &&
           (three * (*this)(b)).sign() > 0;
  }

  friend Cubic operator+(const Cubic& p, const Cubic& q) {
    Cubic sum;
    for (std::size_t k = 0; k < 4; ++k) {
      sum.at_[k] = p.at_[k] + q.at_[k];
    }
    return sum;
  }

  friend Cubic operator-(const Cubic& p, const Cubic& q) { return p + q * Dyadic(-1); }

  friend Cubic operator*(const Cubic& p, const Dyadic& s) {
    Cubic product;
    for (std::size_t k = 0; k < 4; ++k) {
      product.at_[k] = p.at_[k] * s;
    }
    return product;
  }

  /// \pre The degrees of both are 3 at most together.
  friend Cubic operator*(const Cubic& p, const Cubic& q) {
    Cubic product;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; i + j < 4; ++j) {
        if (p.at_[i].sign() != 0 && q.at_[j].sign() != 0) {
          product.at_[i + j] = product.at_[i + j] + p.at_[i] * q.at_[j];
        }
      }
    }
    return product;
  }

 private:
  std::array<Dyadic, 4> at_;
};

}  // namespace soms::reference::detail
