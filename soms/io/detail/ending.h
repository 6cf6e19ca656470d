/// \file
/// Endings of file names.
#pragma once

#include <string>
#include <string_view>

namespace soms::detail {

/// The ending of a file name in lower case, with its point; empty if there is none.
[[nodiscard]] inline std::string ending_of(std::string_view name) {
  const std::size_t point = name.find_last_of("./\\");
  if (point == std::string_view::npos || name[point] != '.') {
    return {};
  }
  std::string ending(name.substr(point));
  for (char& c : ending) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return ending;
}

}  // namespace soms::detail
