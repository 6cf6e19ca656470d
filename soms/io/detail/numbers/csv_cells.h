/// \file
/// Lines of a CSV file as cells.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace soms::detail {

/// What stands between the cells of a table whose first row this is: a semicolon if the row has
/// one, as where the comma is that of decimals, else a comma.
[[nodiscard]] char separator_of(std::string_view first_row);

/// Cells of a line, without blanks around them.
void split_cells(std::string_view line, std::vector<std::string_view>& cells, char separator = ',');

/// What a line holds, but of blanks and comments nothing.
[[nodiscard]] std::optional<std::string_view> row_in(std::string_view line);

}  // namespace soms::detail
