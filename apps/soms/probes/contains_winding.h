/// \file
/// `contains --winding`: sides by the winding number, for models that may be open.
#pragma once

#include "apps/soms/probes/contains.h"
#include "apps/soms/probes/contains_output.h"

namespace soms::command {

class Console;

[[nodiscard]] int run_contains_winding(const ContainsVerbOptions& options, SideFiles& files,
                                       Console& console);

}  // namespace soms::command
