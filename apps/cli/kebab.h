/// \file
/// Names as the command's options and values have them.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace soms::command {

/// "spatial-median" for "spatial_median".
[[nodiscard]] inline std::string kebab(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

}  // namespace soms::command
