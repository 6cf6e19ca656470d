/// \file
/// The fields of answers and options, said once: from these lists come `<<`, the columns of
/// batches, JSON, CSV, NPZ, and the classes and types of Python and JavaScript.
///
/// A list stands below its struct and its batch, in their header:
///
/// \verbatim
/// template <>
/// struct Fields<Within> {
///   static constexpr const char* kName = "Within";
///   static constexpr const char* kMeaning = "Answer of within.";
///   using Batch = WithinBatch;
///   static constexpr auto kList = std::tuple(
///       field("within", &Within::within, &Batch::within, "The distance is at most D."),
///       ...);
/// };
/// \endverbatim
///
/// A struct with a base class has `using Base`, and lists its own fields only. A field that is left
/// out does not compile. Options have a name, a meaning and a list.
#pragma once

#include "soms/base/bracket.h"
#include "soms/describe/field_count.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms {

/// The list of T's fields; specialized below T.
template <class T>
struct Fields;

template <class T>
concept Described = requires {
  Fields<T>::kList;
};

/// A batch has no column of a field.
struct NoColumn {};

/// Where a batch has the two ends of a bracket.
template <class Batch>
struct BracketColumns {
  std::vector<double> Batch::*lower;
  std::vector<double> Batch::*upper;
};

/// A field: what all channels call it, where it is, and what it means. A Bracket is `lower` and
/// `upper` everywhere but in C++.
template <class Owner, class Value, class Column>
struct Field {
  using Type = Value;

  const char* name;
  Value Owner::*place;
  Column column;  ///< a vector of the batch, BracketColumns, one value of all rows, or NoColumn
  const char* column_name;  ///< of the batch; as a rule `name`
  const char* meaning;
  bool of_triangle = false;     ///< says nothing where no triangle is named
  const char* rows = "n";       ///< of a list: how many entries it has
  bool unless_default = false;  ///< says nothing where it is what `Owner{}` has

  [[nodiscard]] constexpr const Value& of(const Owner& owner) const { return owner.*place; }

  /// The same, where no triangle is named, says nothing.
  [[nodiscard]] constexpr Field where_named() const {
    Field field = *this;
    field.of_triangle = true;
    return field;
  }

  /// The same, where nothing was given, says nothing.
  [[nodiscard]] constexpr Field where_given() const {
    Field field = *this;
    field.unless_default = true;
    return field;
  }
};

/// What `<<` counts of a batch of answers T: the entries that `holds` is true of, as in
/// "1 of 2 poses clear". Fields<T>::kCounted is an array of them. With `kCoverage`, a column, it
/// says, too, whether all is decided.
template <class T>
struct Counted {
  bool (*holds)(const T& answer);
  const char* words;
  const char* words_of_one = words;  ///< for a batch of one entry: "1 of 1 ray hits"
};

template <class Owner, class Value, class Column>
[[nodiscard]] constexpr auto field(const char* name, Value Owner::*place, Column column,
                                   const char* meaning) {
  return Field<Owner, Value, Column>{name, place, column, name, meaning};
}

template <class Owner, class Value>
[[nodiscard]] constexpr auto field(const char* name, Value Owner::*place, const char* meaning) {
  return field(name, place, NoColumn(), meaning);
}

/// A list of rows of any length, or what tells where they begin: `rows` entries.
template <class Owner, class Value>
[[nodiscard]] constexpr auto list(const char* name, std::vector<Value> Owner::*place,
                                  const char* rows, const char* meaning) {
  return Field<Owner, std::vector<Value>, NoColumn>{name,    place, NoColumn(), name,
                                                    meaning, false, rows};
}

/// A field whose column has another name.
template <class Owner, class Value, class Column>
[[nodiscard]] constexpr auto field(const char* name, Value Owner::*place, Column column,
                                   const char* column_name, const char* meaning) {
  return Field<Owner, Value, Column>{name, place, column, column_name, meaning};
}

namespace detail {

/// Whether T's list has all of its fields.
template <Described T>
[[nodiscard]] consteval bool lists_all_fields() {
  std::size_t own = std::tuple_size_v<decltype(Fields<T>::kList)>;
  if constexpr (requires { typename Fields<T>::Base; }) {
    ++own;
  }
  return own == field_count<T>();
}

}  // namespace detail

/// Calls `function(field)` for each field of T in order, those of its base class first.
template <Described T, class Function>
constexpr void for_each_field(Function&& function) {
  static_assert(detail::lists_all_fields<T>(), "Fields<T>::kList leaves out a field of T");
  if constexpr (requires { typename Fields<T>::Base; }) {
    for_each_field<typename Fields<T>::Base>(function);
  }
  std::apply([&](const auto&... fields) { (function(fields), ...); }, Fields<T>::kList);
}

/// Whether an answer names a triangle, or a pair of them.
template <Described T>
[[nodiscard]] constexpr bool names_triangle(const T& answer) {
  bool named = false;
  if constexpr (requires { answer.triangle.has_value(); }) {
    named = answer.triangle.has_value();
  } else if constexpr (requires { answer.triangles.has_value(); }) {
    named = answer.triangles.has_value();
  }
  return named;
}

}  // namespace soms
