/// \file
/// Relations of closed bodies in words.
#pragma once

#include "soms/query/solid.h"

#include <string>
#include <string_view>

namespace soms::command {

/// As people read it: "A in B".
[[nodiscard]] std::string_view relation_label(Relation relation);

/// Interior is shared: what --fail-if solid looks for.
[[nodiscard]] bool shares_interior(Relation relation);

/// A line for one answer, of the bodies that are called so.
[[nodiscard]] std::string solid_in_words(const Solid& answer, std::string_view a,
                                         std::string_view b);

}  // namespace soms::command
