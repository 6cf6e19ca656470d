#include "soms/io/detail/numbers/csv_cells.h"

#include "soms/io/detail/text.h"

namespace soms::detail {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

}  // namespace

char separator_of(std::string_view first_row) {
  return first_row.find(';') == std::string_view::npos ? ',' : ';';
}

void split_cells(std::string_view line, std::vector<std::string_view>& cells, char separator) {
  cells.clear();
  while (true) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) {
      return;
    }
    line.remove_prefix(end + 1);
  }
}

std::optional<std::string_view> row_in(std::string_view line) {
  const std::string_view text = trimmed(line);
  return text.empty() || text[0] == '#' ? std::nullopt : std::optional(text);
}

}  // namespace soms::detail
