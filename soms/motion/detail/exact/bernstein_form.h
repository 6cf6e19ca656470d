/// \file
/// A polynomial over one of the cells that halving [0, 1] leads to, by its control points.
#pragma once

#include "soms/motion/detail/exact/integer_polynomial.h"

#include <cstddef>
#include <vector>

namespace soms::detail {

/// Coefficients in Bernstein's form, times a number above 0. The polynomial is in their convex hull
/// all over the cell, the first and the last are its values at the ends, and by Descartes' rule it
/// has as many roots inside as their signs change, or fewer by an even number.
class BernsteinForm {
 public:
  /// Over [0, 1]. \pre It is not 0.
  explicit BernsteinForm(const IntegerPolynomial& p);

  [[nodiscard]] int first_sign() const { return at_.front().sign(); }

  [[nodiscard]] int last_sign() const { return at_.back().sign(); }

  /// How often the signs of coefficients change; zeros are passed over.
  [[nodiscard]] int changes() const;

  /// The sign all over the inside, if that is seen from the coefficients; else 0.
  [[nodiscard]] int sign_inside() const;

  /// Leaves the lower half of the cell and returns the upper one.
  [[nodiscard]] BernsteinForm halve();

 private:
  BernsteinForm() = default;

  std::vector<Integer> at_;
};

}  // namespace soms::detail
