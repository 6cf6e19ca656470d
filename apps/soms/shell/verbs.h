/// \file
/// The verbs of the command, one row each.
#pragma once

#include "apps/cli/program.h"
#include "apps/cli/verb.h"

#include <span>

namespace soms::command {

/// All verbs, sorted by name.
[[nodiscard]] std::span<const Verb> verbs();

/// The command itself.
[[nodiscard]] Program program();

}  // namespace soms::command
