/// \file
/// `contains --winding`: sides by the winding number, for models that may be open.
#pragma once

#include "apps/soms/probes/contains.h"

namespace soms::command {

class Console;

[[nodiscard]] int run_contains_winding(const ContainsVerbOptions& options, Console& console);

}  // namespace soms::command
