/// \file
/// Words that are searched for.
#pragma once

#include <string>

namespace soms::view {

/// True if all of the words in `wanted`, in either case, are in `text`.
[[nodiscard]] bool has_words(const std::string& text, const std::string& wanted);

}  // namespace soms::view
