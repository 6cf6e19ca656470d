/// \file
/// Quotients of whole numbers that leave no rest.
#pragma once

#include "soms/geometry/detail/exact/integer.h"

namespace soms::detail {

/// a / b, from the lowest words up. \pre b is not 0 and divides a.
/// \source Jebelean 1993, An algorithm for exact division.
[[nodiscard]] Integer exact_quotient(const Integer& a, const Integer& b);

}  // namespace soms::detail
