/// \file
/// Limits of double, in which bounds are written.
#pragma once

#include <limits>

namespace soms::detail {

/// Rounding unit 2^-53.
inline constexpr double kRoundingUnit = std::numeric_limits<double>::epsilon() / 2;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace soms::detail
