/// \file
/// Answers as keys of JSON, cells of CSV and arrays of NumPy, by the lists of their fields:
/// whatever the question is, a field is called in a file as it is in C++.
///
/// What says nothing is left out of JSON, empty in CSV, and -1 or nan in arrays. A bracket is
/// `lower` and `upper`.
#pragma once

#include "soms/describe/columns.h"
#include "soms/geometry/georeference.h"
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

/// Adds the array "georeference" of one text, as in CSV, if one is stated.
void add_georeference(NpzFile& file, const Georeference& georeference);

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
    return fmt::format(",\"{}\":[{},{}]", name, value.a, value.b);
  } else if constexpr (Worded<Value>) {
    return fmt::format(",\"{}\":\"{}\"", name, soms::name(value));
  } else if constexpr (requires { value.has_value(); }) {
    return value ? json_key(name, *value) : std::string();
  } else {
    return fmt::format(",\"{}\":{}", name, value);
  }
}

/// Whether row `k` of a batch names a triangle, or a pair of them.
template <class Batch>
[[nodiscard]] bool names_triangle_at(const Batch& batch, std::size_t k) {
  if constexpr (requires { batch.triangle[k].has_value(); }) {
    return batch.triangle[k].has_value();
  } else if constexpr (requires { batch.triangles[k].has_value(); }) {
    return batch.triangles[k].has_value();
  } else {
    return false;
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
    } else if constexpr (std::is_same_v<Value, Vec3> ||
                         std::is_same_v<Value, std::optional<Vec3>>) {
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

/// Adds the cells of an answer. `of_triangle(side, number)` gives the three cells of a triangle, or
/// empty ones; side 0 is the only one, or that of the first body.
template <Described T, class OfTriangle>
void add_field_cells(const T& answer, const OfTriangle& of_triangle, std::string& text) {
  const auto to = std::back_inserter(text);
  detail::for_each_own_field<T>([&](const auto& field) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    const Value& value = field.of(answer);
    if constexpr (std::is_same_v<Value, std::optional<TriangleId>>) {
      text += of_triangle(0, value);
    } else if constexpr (std::is_same_v<Value, std::optional<TrianglePair>>) {
      text += of_triangle(0, value ? std::optional(value->a) : std::nullopt);
      text += ',';
      text += of_triangle(1, value ? std::optional(value->b) : std::nullopt);
    } else if constexpr (std::is_same_v<Value, Bracket>) {
      fmt::format_to(to, "{},{}", value.lower, value.upper);
    } else if (detail::is_unknown(answer, field) ||
               (field.of_triangle && !names_triangle(answer))) {
      text += std::is_same_v<Value, Vec3> ? ",," : "";
    } else if constexpr (std::is_same_v<Value, Vec3>) {
      fmt::format_to(to, "{},{},{}", value.x, value.y, value.z);
    } else if constexpr (std::is_same_v<Value, std::optional<Vec3>>) {
      text += value ? fmt::format("{},{},{}", value->x, value->y, value->z) : ",,";
    } else if constexpr (Worded<Value>) {
      text += name(value);
    } else {
      fmt::format_to(to, "{}", value);
    }
    text += ',';
  });
  text += name(answer.coverage);
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
      } else if constexpr (std::is_same_v<Value, Vec3> ||
                           std::is_same_v<Value, std::optional<Vec3>>) {
        columns_.push_back(&file.column(field.name, Kind::number, {3}));
      } else if constexpr (std::is_same_v<Value, std::optional<TriangleId>>) {
        columns_.push_back(&file.column(field.name, Kind::count));
      } else if constexpr (std::is_same_v<Value, std::optional<TrianglePair>>) {
        columns_.push_back(&file.column(field.name, Kind::count, {2}));
      } else if constexpr (Worded<Value>) {
        columns_.push_back(&file.names(field.name, kWords<Value>.names));
      } else if constexpr (std::is_unsigned_v<Value>) {
        columns_.push_back(&file.column(field.name, Kind::count));
      } else {
        static_assert(std::is_same_v<Value, Cost>, "say how this is kept in an array");
      }
    });
  }

  /// Adds the first rows of a batch of answers T. \pre `begin` was called for T.
  template <Described T>
  void add(const BatchOf<T>& batch, std::size_t rows) {
    auto array = columns_.begin();
    for_each_field<T>([&](const auto& field) {
      using Value = typename std::remove_cvref_t<decltype(field)>::Type;
      if constexpr (std::is_same_v<Value, Bracket>) {
        add_rows<double>(**array++, batch.*field.column.lower, rows,
                         [](std::size_t) { return true; });
        add_rows<double>(**array++, batch.*field.column.upper, rows,
                         [](std::size_t) { return true; });
      } else if constexpr (!std::is_same_v<Value, Cost>) {
        add_rows<Value>(**array++, batch.*field.column, rows, [&](std::size_t k) {
          return !field.of_triangle || detail::names_triangle_at(batch, k);
        });
      }
    });
  }

 private:
  using Kind = NpzColumn::Kind;
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  template <class Value, class Column, class Says>
  static void add_rows(NpzColumn& array, const Column& column, std::size_t rows,
                       const Says& says_something) {
    for (std::size_t k = 0; k < rows; ++k) {
      const auto& value = column[k];
      if constexpr (std::is_same_v<Value, Vec3>) {
        array.add(says_something(k) ? value : Vec3{kNone, kNone, kNone});
      } else if constexpr (std::is_same_v<Value, std::optional<Vec3>>) {
        array.add(value.value_or(Vec3{kNone, kNone, kNone}));
      } else if constexpr (std::is_same_v<Value, std::optional<TriangleId>>) {
        array.add(value ? std::int64_t{*value} : -1);
      } else if constexpr (std::is_same_v<Value, std::optional<TrianglePair>>) {
        array.add(value ? std::int64_t{value->a} : -1);
        array.add(value ? std::int64_t{value->b} : -1);
      } else if constexpr (Worded<Value>) {
        array.add(static_cast<std::uint8_t>(value));
      } else if constexpr (std::is_same_v<Value, bool>) {
        array.add(value != 0);
      } else if constexpr (std::is_unsigned_v<Value>) {
        array.add(static_cast<std::int64_t>(value));
      } else {
        array.add(value);
      }
    }
  }

  std::vector<NpzColumn*> columns_;
};

}  // namespace soms::command
