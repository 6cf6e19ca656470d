/// \file
/// `overlap --verify`: is an answer what brute force allows?
#pragma once

#include "soms/query/overlap.h"

namespace soms::command {

/// True if `answer` is what brute force allows for the question.
[[nodiscard]] bool agrees(const Overlap& answer, const Overlap& truth, OverlapMode mode);

}  // namespace soms::command
