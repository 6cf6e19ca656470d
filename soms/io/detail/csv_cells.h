/// \file
/// Lines of a CSV file as cells.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Cells of a line, without blanks around them.
void split_cells(std::string_view line, std::vector<std::string_view>& cells);

/// What a line holds, but of blanks and comments nothing.
[[nodiscard]] std::optional<std::string_view> row_in(std::string_view line);

}  // namespace soms::detail
