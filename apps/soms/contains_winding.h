/// \file
/// `contains --winding`: sides by the winding number, for models that may be open.
#pragma once

#include "apps/soms/answer_columns.h"
#include "apps/soms/contains.h"

namespace soms::command {

class Console;

[[nodiscard]] int run_contains_winding(const ContainsVerbOptions& options, SideColumns& columns,
                                       Console& console);

}  // namespace soms::command
