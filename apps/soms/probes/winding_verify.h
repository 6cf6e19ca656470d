/// \file
/// `contains --winding --verify`: is a winding number what brute force allows?
#pragma once

#include "soms/base/bracket.h"

namespace soms::command {

/// True if both brackets may hold the same number. One with a bound that is no number holds none.
[[nodiscard]] bool agrees(const Bracket& number, const Bracket& truth);

}  // namespace soms::command
