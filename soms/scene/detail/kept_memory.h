/// \file
/// Memory that is kept from call to call, and given back once it is far above what is needed.
#pragma once

#include <cstddef>
#include <vector>

namespace soms::detail {

/// Memory above this many times what is needed is given back: enough that growing again is paid for
/// by the work that needs it.
inline constexpr std::size_t kMostSpare = 4;
/// Less than this, in bytes, is never worth giving back.
inline constexpr std::size_t kLeastGivenBack = std::size_t{1} << 14;

/// Bytes that a vector holds for its values.
template <typename Value>
[[nodiscard]] std::size_t bytes(const std::vector<Value>& values) {
  return values.capacity() * sizeof(Value);  // NOLINT(bugprone-sizeof-expression): pointers, too
}

/// True if `held` bytes are far more than the `needed` ones.
[[nodiscard]] inline bool is_far_above(std::size_t held, std::size_t needed,
                                       std::size_t least = kLeastGivenBack) {
  return held > kMostSpare * needed + least;
}

/// Where room for far more than `needed` values is held, cuts `values` to these and gives back what
/// remains.
template <typename Value>
void give_back(std::vector<Value>& values, std::size_t needed,
               std::size_t least = kLeastGivenBack) {
  if (is_far_above(bytes(values), needed * sizeof(Value), least)) {
    if (needed < values.size()) {
      values.erase(values.begin() + static_cast<std::ptrdiff_t>(needed), values.end());
    }
    values.shrink_to_fit();
  }
}

/// Gives back all memory; to assign `{}` would keep it.
template <typename Value>
void release(std::vector<Value>& values) {
  std::vector<Value>().swap(values);
}

/// As `give_back` for a vector whose values are all needed.
template <typename Value>
void give_back(std::vector<Value>& values) {
  give_back(values, values.size());
}

}  // namespace soms::detail
