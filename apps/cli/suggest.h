/// \file
/// The word that was meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// The known words nearest to `word` by edit distance (insert, delete, replace, swap neighbors), as
/// a question has them, "--up or --up-b": the first three that are equally near. An empty string if
/// none is within a third of its length, at least 1 and at most 3. A word that begins with `word`
/// counts as near; one that differs in case, or in `_` for `-`, is the nearest. For a word of one
/// or two letters nothing else may differ.
[[nodiscard]] std::string nearest_words(std::string_view word,
                                        const std::vector<std::string>& known);

}  // namespace soms::command
