/// \file
/// Loads that begin before they are needed.
#pragma once

#include <cstddef>

namespace soms::detail {

/// Starts to load what will be looked at soon.
template <class Node>
inline void fetch(const Node& place) {
  constexpr std::size_t kLine = 64;
  const auto* const bytes = reinterpret_cast<const char*>(&place);
  for (std::size_t line = 0; line < sizeof(Node); line += kLine) {
    __builtin_prefetch(bytes + line);
  }
}

}  // namespace soms::detail
