/// \file
/// File extensions.
#pragma once

#include <string>
#include <string_view>

namespace soms::detail {

/// The extension of a file name in lower case, with its point; empty if there is none.
[[nodiscard]] inline std::string extension_of(std::string_view name) {
  const std::size_t point = name.find_last_of("./\\");
  if (point == std::string_view::npos || name[point] != '.') {
    return {};
  }
  std::string extension(name.substr(point));
  for (char& c : extension) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return extension;
}

}  // namespace soms::detail
