/// \file
/// Polynomials in one unknown whose coefficients are whole numbers of any length.
#pragma once

#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/integer.h"

#include <array>
#include <cstddef>
#include <vector>

namespace soms::detail {

/// The sum of coefficient k times s^k.
class IntegerPolynomial {
 public:
  /// 0
  IntegerPolynomial() = default;

  explicit IntegerPolynomial(std::vector<Integer> coefficients);

  [[nodiscard]] bool is_zero() const { return at_.empty(); }

  /// 0 for 0, too.
  [[nodiscard]] std::size_t degree() const { return at_.empty() ? 0 : at_.size() - 1; }

  /// From the constant to the leading one, which is not 0.
  [[nodiscard]] const std::vector<Integer>& coefficients() const { return at_; }

  /// That of s^k, 0 beyond the degree.
  [[nodiscard]] Integer at(std::size_t k) const { return k < at_.size() ? at_[k] : Integer(); }

  /// The sign at above / below. \pre below > 0
  [[nodiscard]] int sign_at(const Integer& above, const Integer& below) const;

  [[nodiscard]] IntegerPolynomial derivative() const;

  friend IntegerPolynomial operator+(const IntegerPolynomial& p, const IntegerPolynomial& q);
  friend IntegerPolynomial operator-(const IntegerPolynomial& p, const IntegerPolynomial& q);
  friend IntegerPolynomial operator*(const IntegerPolynomial& p, const IntegerPolynomial& q);
  friend IntegerPolynomial operator*(const IntegerPolynomial& p, const Integer& s);

 private:
  std::vector<Integer> at_;
};

/// A vector of them.
using PolynomialVec = std::array<IntegerPolynomial, 3>;

[[nodiscard]] PolynomialVec operator+(const PolynomialVec& a, const PolynomialVec& b);
[[nodiscard]] PolynomialVec operator-(const PolynomialVec& a, const PolynomialVec& b);
[[nodiscard]] PolynomialVec operator*(const IntegerVec& v, const IntegerPolynomial& p);
[[nodiscard]] IntegerPolynomial dot(const PolynomialVec& a, const IntegerVec& b);
[[nodiscard]] IntegerPolynomial dot(const PolynomialVec& a, const PolynomialVec& b);
[[nodiscard]] PolynomialVec cross(const PolynomialVec& a, const IntegerVec& b);

/// A polynomial of the highest degree that divides both, times some number that is not 0. No roots
/// in common give a constant. \pre Not both are 0.
/// \source Knuth, The Art of Computer Programming 2, 4.6.1, algorithm C (subresultants).
[[nodiscard]] IntegerPolynomial common_divisor(IntegerPolynomial p, IntegerPolynomial q);

/// A polynomial with the same roots, each once. \pre It is not 0.
[[nodiscard]] IntegerPolynomial with_single_roots(const IntegerPolynomial& p);

}  // namespace soms::detail
