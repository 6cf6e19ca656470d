/// \file
/// `distance --verify`: is an answer what brute force allows?
#pragma once

#include "soms/query/distance.h"

namespace soms::command {

/// True if brute force, which found `truth`, allows `answer` to a question with this `at_most`.
[[nodiscard]] bool agrees(const Distance& answer, const Distance& truth, double at_most);

}  // namespace soms::command
