/// \file
/// The verb `thesis`, or what says that it is not built (apps/soms/no_thesis).
#pragma once

#include "apps/cli/verb.h"

#include <string_view>

namespace soms::command {

inline constexpr std::string_view kThesisVerb = "thesis";
inline constexpr std::string_view kThesisQuestion =
    "run the orientation tests of the thesis: counts, times and contacts by frame";

[[nodiscard]] Verb thesis_verb();

}  // namespace soms::command
