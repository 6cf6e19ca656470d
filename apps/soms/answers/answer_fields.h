/// \file
/// Answers as keys of JSON, cells of CSV and arrays of NumPy, by the lists of their fields:
/// whatever the question is, a field is called in a file as it is in C++.
///
/// What says nothing is left out of JSON, empty in CSV, and -1 or nan in arrays. A bracket is
/// `lower` and `upper`.
#pragma once

#include "soms/describe/columns.h"
#include "soms/query/answer.h"

#include "apps/output/npz_file.h"

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace soms::command {

inline constexpr std::size_t kUsualRow =
    256;  // bytes of a row of CSV, so that it is allocated once

/// A number of JSON that reads back exactly; infinity is null.
[[nodiscard]] std::string json_number(double x);

namespace detail {

/// The field of T that an answer is about is false because time ended: nobody knows.
template <Described T>
[[nodiscard]] bool is_unknown(const T& answer, const auto& field) {
  if constexpr (requires { Fields<T>::kTruth; } &&
                std::is_same_v<decltype(field.place), bool T::*>) {
    return field.place == Fields<T>::kTruth && !field.of(answer) &&
           answer.coverage == Coverage::cut;
  } else {
    return false;
  }
}

/// ",\"name\":value" of a field; nothing where it says nothing.
template <class Value>
[[nodiscard]] std::string json_key(const char* name, const Value& value) {
  if constexpr (std::is_same_v<Value, Bracket>) {
    return json_key("lower", value.lower) + json_key("upper", value.upper);
  } else if constexpr (std::is_same_v<Value, double>) {
    return fmt::format(",\"{}\":{}", name, json_number(value));
  } else if constexpr (std::is_same_v<Value, Vec3>) {
    return fmt::format(",\"{}\":[{},{},{}]", name, value.x, value.y, value.z);
  } else if constexpr (std::is_same_v<Value, TrianglePair>) {
    return fmt::format(",\"{}\":[{},{}]", name, value.first, value.second);
  } else if constexpr (Worded<Value>) {
    return fmt::format(",\"{}\":\"{}\"", name, soms::name(value));
  } else if constexpr (requires { value.has_value(); }) {
    return value ? json_key(name, *value) : std::string();
  } else {
    return fmt::format(",\"{}\":{}", name, value);
  }
}

/// Calls `function(field)` for the fields of T but how much was decided and what it cost, which
/// rows end with.
template <Described T, class Function>
void for_each_own_field(Function&& function) {
  for_each_field<T>([&](const auto& field) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (!std::is_same_v<Value, Coverage> && !std::is_same_v<Value, Cost>) {
      function(field);
    }
  });
}

}  // namespace detail

/// The fields of an answer as keys of JSON, each with a comma before; null for a flag that is not
/// known.
template <Described T>
[[nodiscard]] std::string field_keys(const T& answer) {
  std::string text;
  detail::for_each_own_field<T>([&](const auto& field) {
    if (detail::is_unknown(answer, field)) {
      text += fmt::format(",\"{}\":null", field.name);
    } else if (!field.of_triangle || names_triangle(answer)) {
      text += detail::json_key(field.name, field.of(answer));
    }
  });
  return text;
}

/// Names of the cells of an answer, with commas between. A triangle has two cells more: its part
/// and the part's name.
template <Described T>
[[nodiscard]] std::string field_head() {
  std::string text;
  const auto add = [&](const std::string& cells) { text += (text.empty() ? "" : ",") + cells; };
  detail::for_each_own_field<T>([&](const auto& field) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    const std::string name = field.name;
    if constexpr (std::is_same_v<Value, Bracket>) {
      add("lower,upper");
    } else if constexpr (std::is_same_v<Value, Vec3>) {
      add(name + "_x," + name + "_y," + name + "_z");
    } else if constexpr (std::is_same_v<Value, std::optional<TriangleId>>) {
      add("triangle,part,name");
    } else if constexpr (std::is_same_v<Value, std::optional<TrianglePair>>) {
      add("triangle_a,part_a,name_a,triangle_b,part_b,name_b");
    } else {
      add(name);
    }
  });
  return text + ",coverage";
}

/// The cells of an answer. `of_triangle(side, number)` gives the three cells of a triangle, or
/// empty ones; side 0 is the only one, or that of the first body.
template <Described T, class OfTriangle>
[[nodiscard]] std::string field_cells(const T& answer, const OfTriangle& of_triangle) {
  std::string text;
  text.reserve(kUsualRow);
  const auto to = std::back_inserter(text);
  detail::for_each_own_field<T>([&](const auto& field) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    const Value& value = field.of(answer);
    if constexpr (std::is_same_v<Value, std::optional<TriangleId>>) {
      text += of_triangle(0, value);
    } else if constexpr (std::is_same_v<Value, std::optional<TrianglePair>>) {
      text += of_triangle(0, value ? std::optional(value->first) : std::nullopt);
      text += ',';
      text += of_triangle(1, value ? std::optional(value->second) : std::nullopt);
    } else if constexpr (std::is_same_v<Value, Bracket>) {
      fmt::format_to(to, "{},{}", value.lower, value.upper);
    } else if (detail::is_unknown(answer, field) ||
               (field.of_triangle && !names_triangle(answer))) {
      text += std::is_same_v<Value, Vec3> ? ",," : "";
    } else if constexpr (std::is_same_v<Value, Vec3>) {
      fmt::format_to(to, "{},{},{}", value.x, value.y, value.z);
    } else if constexpr (Worded<Value>) {
      text += name(value);
    } else {
      fmt::format_to(to, "{}", value);
    }
    text += ',';
  });
  text += name(answer.coverage);
  return text;
}

/// Arrays of a file, one for each field of an answer.
class FieldColumns {
 public:
  /// Adds empty arrays of answers T to the file, which must stay.
  template <Described T>
  void begin(NpzFile& file) {
    for_each_field<T>([&](const auto& field) {
      using Value = typename std::remove_cvref_t<decltype(field)>::Type;
      if constexpr (std::is_same_v<Value, Bracket>) {
        columns_.push_back(&file.column("lower", Kind::number));
        columns_.push_back(&file.column("upper", Kind::number));
      } else if constexpr (std::is_same_v<Value, double>) {
        columns_.push_back(&file.column(field.name, Kind::number));
      } else if constexpr (std::is_same_v<Value, bool>) {
        columns_.push_back(&file.column(field.name, Kind::flag));
      } else if constexpr (std::is_same_v<Value, Vec3>) {
        columns_.push_back(&file.column(field.name, Kind::number, {3}));
      } else if constexpr (std::is_same_v<Value, std::optional<TriangleId>>) {
        columns_.push_back(&file.column(field.name, Kind::count));
      } else if constexpr (std::is_same_v<Value, std::optional<TrianglePair>>) {
        columns_.push_back(&file.column(field.name, Kind::count, {2}));
      } else if constexpr (Worded<Value>) {
        columns_.push_back(&file.names(field.name, kWords<Value>.names));
      } else {
        static_assert(std::is_same_v<Value, Cost>, "say how this is kept in an array");
      }
    });
  }

  /// \pre `begin` was called for T.
  template <Described T>
  void add(const T& answer) {
    auto column = columns_.begin();
    for_each_field<T>([&](const auto& field) {
      using Value = typename std::remove_cvref_t<decltype(field)>::Type;
      const Value& value = field.of(answer);
      if constexpr (std::is_same_v<Value, Bracket>) {
        (*column++)->add(value.lower);
        (*column++)->add(value.upper);
      } else if constexpr (std::is_same_v<Value, Vec3>) {
        const bool there = !field.of_triangle || names_triangle(answer);
        (*column++)->add(there ? value : Vec3{kNone, kNone, kNone});
      } else if constexpr (std::is_same_v<Value, std::optional<TriangleId>>) {
        (*column++)->add(value ? std::int64_t{*value} : -1);
      } else if constexpr (std::is_same_v<Value, std::optional<TrianglePair>>) {
        (*column)->add(value ? std::int64_t{value->first} : -1);
        (*column++)->add(value ? std::int64_t{value->second} : -1);
      } else if constexpr (Worded<Value>) {
        (*column++)->add(static_cast<std::uint8_t>(value));
      } else if constexpr (!std::is_same_v<Value, Cost>) {
        (*column++)->add(value);
      }
    });
  }

 private:
  using Kind = NpzColumn::Kind;
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::vector<NpzColumn*> columns_;
};

}  // namespace soms::command
