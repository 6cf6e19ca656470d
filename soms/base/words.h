/// \file
/// The words of enumerations, said once: C++, Python, JavaScript, JSON, CSV and NPZ have the same.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace soms {

/// The words of E, in the order of its values from 0 on; specialized beside E.
template <class E>
inline constexpr std::nullptr_t kWords = nullptr;

/// What an enumeration is called, what it is about, and its words.
template <std::size_t N>
struct Words {
  std::string_view type;
  std::string_view meaning;
  std::array<std::string_view, N> names;
};

template <class... Names>
[[nodiscard]] consteval auto words(std::string_view type, std::string_view meaning,
                                   Names... names) {
  return Words<sizeof...(Names)>{type, meaning, {std::string_view(names)...}};
}

/// An enumeration whose words are known.
template <class E>
concept Worded = requires {
  kWords<E>.names.size();
};

/// The word of a value; "" where it has none.
template <Worded E>
[[nodiscard]] constexpr std::string_view name(E value) {
  const auto place = static_cast<std::size_t>(value);
  return place < kWords<E>.names.size() ? kWords<E>.names[place] : std::string_view();
}

}  // namespace soms
