/// \file
/// The verb `version`: what this soms is, and what it can do here.
#pragma once

#include "apps/cli/verb.h"

namespace soms::command {

class Console;

/// Adds the verb's options.
[[nodiscard]] Action add_version(Parser& parser, Shared& shared);

/// Prints the version, the instruction set that queries run on, and the formats.
[[nodiscard]] int run_version(Console& console);

}  // namespace soms::command
