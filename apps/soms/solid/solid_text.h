/// \file
/// Relations of closed bodies in words.
#pragma once

#include "soms/query/solid.h"

#include <string>
#include <string_view>

namespace soms::command {

/// As in JSON: "a_in_b".
[[nodiscard]] std::string_view relation_name(Relation relation);

/// As people read it: "A in B".
[[nodiscard]] std::string_view relation_label(Relation relation);

/// Why it is undecided, as in JSON: "deadline", "open".
[[nodiscard]] std::string_view reason_name(Undecided why);

/// Interior is shared: what --fail-if solid looks for.
[[nodiscard]] bool shares_interior(Relation relation);

/// A line for one answer, of the bodies that are called so.
[[nodiscard]] std::string solid_in_words(const Solid& answer, std::string_view a,
                                         std::string_view b);

/// The keys "relation", "surfaces_meet" and "why" of JSON.
[[nodiscard]] std::string solid_keys(const Solid& answer);

}  // namespace soms::command
