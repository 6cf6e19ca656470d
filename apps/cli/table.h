/// \file
/// A table whose columns are as wide as their cells, for people.
#pragma once

#include "apps/cli/terminal.h"

#include <optional>
#include <string>
#include <vector>

namespace soms::command {

struct TableColumn {
  std::string head;
  bool right = false;     ///< cells end where the column does, as numbers do
  bool shortens = false;  ///< cells lose their middle where the table is too wide
};

struct TableRow {
  std::vector<std::string> cells;         ///< one for each column
  std::optional<Ink> ink = std::nullopt;  ///< of the first cell
};

/// Head and rows, a line each, two blanks before each cell. Columns without any cell are left out.
[[nodiscard]] std::string table_text(const std::vector<TableColumn>& columns,
                                     std::vector<TableRow> rows, const Terminal& terminal);

}  // namespace soms::command
