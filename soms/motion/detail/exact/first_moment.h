/// \file
/// When conditions on polynomials first hold.
#pragma once

#include "soms/motion/detail/exact/integer_polynomial.h"
#include "soms/motion/detail/exact/unit_root.h"

#include <optional>
#include <vector>

namespace soms::detail {

/// The sign all over [0, 1], both ends included, if that is seen at once; else 0.
[[nodiscard]] int sure_sign(const IntegerPolynomial& p);

/// All of them hold at a moment s in [0, 1] together.
struct MomentConditions {
  std::vector<IntegerPolynomial> zero;          ///< are 0
  std::vector<IntegerPolynomial> not_negative;  ///< are 0 or above
  std::optional<IntegerPolynomial> nonzero;     ///< is not 0
};

/// The moments at which the conditions hold, those that may be the first one: the first is among
/// them. A condition of the last kind may leave no first moment; then there may be none, or a later
/// one.
///
/// Where a polynomial that is to be 0 is not 0 throughout, moments are its roots, and the signs of
/// all others are decided there. Else the conditions hold in closed intervals of time. Each begins
/// at 0 or at a root of one that is not negative inside.
[[nodiscard]] std::vector<UnitRoot> first_moments(const MomentConditions& conditions);

}  // namespace soms::detail
