/// \file
/// What the `<<` of every value is made of: "Type{field: value, field: value}", on one line.
#pragma once

#include "soms/base/text.h"

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace soms {

/// A value as text: numbers by their shortest digits, words in quotes, all else as its `<<` prints
/// it.
template <class T>
[[nodiscard]] std::string printed(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_floating_point_v<T>) {
    return shortest(value);
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  } else if constexpr (std::is_convertible_v<const T&, std::string_view>) {
    return quoted_text(value);
  } else {
    std::ostringstream out;
    out << value;
    return std::move(out).str();
  }
}

/// "1 triangle", "12 triangles".
[[nodiscard]] std::string printed_count(std::size_t count, std::string_view singular,
                                        std::string_view plural);

/// A value's type and fields, put together. Formats of the stream (width apart), its locale and the
/// precision have no effect, so the text of a value is always the same.
class PrintedFields {
 public:
  explicit PrintedFields(std::string_view type) : text_(std::string(type) + "{") {}

  /// "field: value".
  template <class T>
  PrintedFields& add(std::string_view field, const T& value) {
    return item(std::string(field) + ": " + printed(value));
  }

  /// Words without the name of a field.
  PrintedFields& item(std::string_view words);

  friend std::ostream& operator<<(std::ostream& out, const PrintedFields& fields) {
    return out << fields.text_ + "}";
  }

 private:
  std::string text_;
  bool empty_ = true;
};

}  // namespace soms
