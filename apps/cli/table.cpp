#include "apps/cli/table.h"

#include "apps/cli/text.h"

#include <algorithm>
#include <cstddef>

namespace soms::command {

namespace {

constexpr std::size_t kGap = 2;
constexpr std::size_t kLeastName = 12;

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
}

/// Characters of UTF-8.
std::size_t width_of(const std::string& cell) {
  return static_cast<std::size_t>(std::count_if(cell.begin(), cell.end(), begins_character));
}

/// Where character `number` begins, or the end.
std::size_t place_of(const std::string& cell, std::size_t number) {
  std::size_t at = 0;
  for (; at < cell.size(); ++at) {
    if (begins_character(cell[at]) && number-- == 0) {
      break;
    }
  }
  return at;
}

/// The widths of columns; 0 for those that are left out.
std::vector<std::size_t> widths_of(const std::vector<TableColumn>& columns,
                                   const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::size_t widest = 0;
    for (const TableRow& row : rows) {
      widest = std::max(widest, width_of(row.cells[k]));
    }
    widths.push_back(widest == 0 ? 0 : std::max(widest, columns[k].head.size()));
  }
  return widths;
}

/// Takes from the widest column that shortens, as long as the table is too wide.
void fit(const std::vector<TableColumn>& columns, std::size_t most,
         std::vector<std::size_t>& widths) {
  const auto total = [&widths] {
    std::size_t sum = 0;
    for (const std::size_t width : widths) {
      sum += width == 0 ? 0 : kGap + width;
    }
    return sum;
  };
  while (most != 0 && total() > most) {
    std::size_t* widest = nullptr;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k].shortens && widths[k] > kLeastName &&
          (widest == nullptr || widths[k] > *widest)) {
        widest = &widths[k];
      }
    }
    if (widest == nullptr) {
      return;
    }
    --*widest;
  }
}

/// Both of its ends: names that differ often do so at the last letters.
std::string without_middle(const std::string& cell, std::size_t width) {
  constexpr std::size_t kDots = 3;
  const std::size_t whole = width_of(cell);
  if (whole <= width) {
    return cell;
  }
  const std::size_t tail = (width - kDots) / 2;
  return cell.substr(0, place_of(cell, width - kDots - tail)) + "..." +
         cell.substr(place_of(cell, whole - tail));
}

}  // namespace

std::string table_text(const std::vector<TableColumn>& columns, std::vector<TableRow> rows,
                       const Terminal& terminal) {
  std::vector<std::size_t> widths = widths_of(columns, rows);
  fit(columns, terminal.width, widths);
  TableRow head{.cells = {}, .ink = {}};
  for (const TableColumn& column : columns) {
    head.cells.push_back(column.head);
  }
  rows.insert(rows.begin(), std::move(head));
  std::string text;
  for (std::size_t at = 0; at < rows.size(); ++at) {
    std::string line;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (widths[k] == 0) {
        continue;
      }
      const std::string cell =
          columns[k].shortens ? without_middle(rows[at].cells[k], widths[k]) : rows[at].cells[k];
      const std::string blanks(widths[k] - std::min(widths[k], width_of(cell)), ' ');
      const bool inked = rows[at].ink && line.empty();
      const std::string shown = inked ? terminal.paint(cell, *rows[at].ink) : cell;
      line += std::string(kGap, ' ') + (columns[k].right ? blanks + shown : shown + blanks);
    }
    line = table_line(line);
    text += at == 0 ? terminal.paint(line.substr(0, line.size() - 1), Ink::heading) + "\n" : line;
  }
  return text;
}

}  // namespace soms::command
