/// \file
/// Roots of polynomials in [0, 1]: numbers that are known by what they are roots of.
#pragma once

#include "soms/motion/detail/exact/bernstein_form.h"
#include "soms/motion/detail/exact/integer_polynomial.h"

#include <compare>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace soms::detail {

/// One root. Either it is number / 2^halvings, or it is the only root of its polynomial, and a
/// single one, inside the cell from there to (number + 1) / 2^halvings. No end of that cell is a
/// root then.
class UnitRoot {
 public:
  /// How the root stands to above / below. \pre below > 0
  [[nodiscard]] std::strong_ordering compare(const Integer& above, const Integer& below) const;

  /// The sign of another polynomial at the root. The cell is halved until it shows; if that takes
  /// long, a common divisor says whether it is 0.
  [[nodiscard]] int sign_of(const IntegerPolynomial& p);

 private:
  friend class UnitRoots;

  UnitRoot(std::shared_ptr<const IntegerPolynomial> polynomial, BernsteinForm form)
      : polynomial_(std::move(polynomial)), form_(std::move(form)) {}

  [[nodiscard]] Integer scale() const { return Integer(1, halvings_); }

  [[nodiscard]] bool is_root_of(const IntegerPolynomial& p) const;
  [[nodiscard]] BernsteinForm form_here(const IntegerPolynomial& p) const;
  void halve(BernsteinForm& other);

  std::shared_ptr<const IntegerPolynomial> polynomial_;
  BernsteinForm form_;  ///< over the cell
  Integer number_;
  std::size_t halvings_ = 0;
  bool known_ = false;  ///< it is number / 2^halvings
};

/// All roots in [0, 1], each once, from the least on. \pre The polynomial is not 0.
[[nodiscard]] std::vector<UnitRoot> unit_roots(const IntegerPolynomial& p);

}  // namespace soms::detail
