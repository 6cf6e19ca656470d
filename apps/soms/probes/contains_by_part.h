/// \file
/// `contains --by part` and `--by connected`: which parts of a model hold each point.
#pragma once

#include "apps/soms/probes/contains.h"

namespace soms::command {

class Console;

[[nodiscard]] int run_contains_by_part(const ContainsVerbOptions& options, Console& console);

}  // namespace soms::command
