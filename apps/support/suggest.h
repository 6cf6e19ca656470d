/// \file
/// The word that was meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// The known word nearest to `word` by edit distance (insert, delete, replace, swap neighbors), or
/// an empty string if none is within a third of its length, at least 1 and at most 3. A word that
/// begins with `word` counts as near. A word that differs in case, or in `_` for `-`, is the
/// nearest. Ties go to the first. For a word of one or two letters nothing else may differ.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       const std::vector<std::string>& known);

}  // namespace soms::command
