/// \file
/// A model that a verb needs closed, and the names of its sides.
#pragma once

#include "soms/query/body.h"
#include "soms/query/contains.h"

#include <string_view>

namespace soms::command {

class Console;

/// \errors As ClosedBody; where the surface is open, `otherwise` ends the remedy.
[[nodiscard]] ClosedBody closed_body(Body body, std::string_view otherwise, Console& console);

}  // namespace soms::command
