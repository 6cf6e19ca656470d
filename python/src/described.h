/// \file
/// Classes of Python from the lists of fields that answers have in C++ (soms/describe/fields.h).
#pragma once

#include "soms/describe/columns.h"
#include "soms/query/answer.h"

#include "python/src/answer.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms::python {

/// The array that a column of T's is: "(n,) bool".
template <class T>
[[nodiscard]] std::string array_text(const std::string& rows) {
  const std::string list = "(" + rows + ",) ";
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::uint8_t>) {
    return list + "bool";
  } else if constexpr (std::is_same_v<T, double>) {
    return list + "float64";
  } else if constexpr (std::is_same_v<T, std::uint32_t>) {
    return list + "uint32";
  } else if constexpr (std::is_same_v<T, std::uint64_t>) {
    return list + "uint64";
  } else if constexpr (std::is_same_v<T, std::optional<std::uint32_t>>) {
    return list + "int64, -1 for none";
  } else if constexpr (std::is_same_v<T, std::optional<TrianglePair>>) {
    return "(" + rows + ", 2) int64, -1 for none";
  } else if constexpr (std::is_same_v<T, std::optional<Vec3>>) {
    return "(" + rows + ", 3) float64, NaN for none";
  } else if constexpr (std::is_same_v<T, TrianglePair>) {
    return "(" + rows + ", 2) uint32";
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return "(" + rows + ", 3) float64";
  } else if constexpr (Worded<T>) {
    return list + "integers of " + std::string(kWords<T>.type);
  } else if constexpr (Described<T>) {
    std::string names;
    for_each_field<T>([&](const auto& field) {
      using Value = typename std::remove_cvref_t<decltype(field)>::Type;
      names += (names.empty() ? "" : ", ") +
               std::string(std::is_same_v<Value, Bracket> ? "lower, upper" : field.name);
    });
    return list + "with fields " + names;
  } else {
    // One of many fields: a number each, as what is missing has no type of its own.
    using Struct = typename T::value_type;
    constexpr std::size_t kCount = std::tuple_size_v<decltype(Fields<Struct>::kList)>;
    return "(" + rows + ", " + std::to_string(kCount) + ") int64, -1 for none";
  }
}

/// What a field means, and what it is where it means nothing.
[[nodiscard]] std::string meaning_of(const auto& field) {
  return std::string(field.meaning) + (field.of_triangle ? " 0 without a triangle." : "");
}

/// Binds the fields of a single answer, as properties of these names.
template <class T, class Class>
void def_fields(Class& one) {
  for_each_field<T>([&](const auto& field) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    const auto place = field.place;
    const std::string meaning = meaning_of(field);
    if constexpr (std::is_same_v<Value, Bracket>) {
      one.derived(
          "lower", [place](const T& answer) { return (answer.*place).lower; },
          (meaning + " is at least this.").c_str());
      one.derived(
          "upper", [place](const T& answer) { return (answer.*place).upper; },
          (meaning + " is at most this.").c_str());
    } else if constexpr (detail::kIs<Value, std::vector>) {
      using Row = typename Value::value_type;
      one.column(field.name, place, (array_text<Row>(field.rows) + ". " + meaning).c_str());
    } else if constexpr (std::is_same_v<Value, bool>) {
      if constexpr (requires { Fields<T>::kTruth; }) {
        if (place == Fields<T>::kTruth) {
          one.truth(field.name, place, field.meaning);
          return;
        }
      }
      one.field(field.name, place, meaning.c_str());
    } else {
      const bool maybe = detail::kIs<Value, std::optional>;
      one.field(field.name, place, (meaning + (maybe ? " None if there is none." : "")).c_str());
    }
  });
}

/// Binds a column, as `array_text` says.
template <class Class, class Batch, class V>
void def_column(Class& batch, const char* name, std::vector<V> Batch::*place,
                const std::string& meaning) {
  batch.column(name, place, (array_text<V>("n") + ". " + meaning).c_str());
}

/// Binds the columns of T's batch, by the fields of T.
template <class T, class Class>
void def_columns(Class& batch) {
  using Batch = BatchOf<T>;
  for_each_field<T>([&](const auto& field) {
    using Of = std::remove_cvref_t<decltype(field)>;
    const std::string meaning = meaning_of(field);
    if constexpr (std::is_same_v<typename Of::Type, Bracket>) {
      def_column(batch, "lower", field.column.lower, meaning + " is at least this.");
      def_column(batch, "upper", field.column.upper, meaning + " is at most this.");
    } else if constexpr (soms::detail::ColumnTraits<decltype(field.column)>::kIsVector) {
      def_column(batch, field.column_name, field.column, meaning);
    } else {
      batch.field(field.column_name, field.column, field.meaning);
    }
  });
  if constexpr (requires { &Batch::cost; }) {
    batch.field("cost", &Batch::cost,
                (std::string("Work done for all ") + Fields<T>::kRows + " together.").c_str());
  }
}

/// The name of a flag of T.
template <class T>
[[nodiscard]] const char* name_of(bool T::*flag) {
  const char* name = "";
  for_each_field<T>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(field.place), bool T::*>) {
      name = field.place == flag ? field.name : name;
    }
  });
  return name;
}

/// The class of answers T, or of lists of rows.
template <class T>
AnswerClass<T> bind_answer(py::module_& module) {
  std::string meaning = Fields<T>::kMeaning;
  if constexpr (requires { Fields<T>::kTruth; }) {
    meaning += std::string(" Its truth is that of ") + name_of(Fields<T>::kTruth) + ".";
  }
  AnswerClass<T> one(module, Fields<T>::kName, meaning.c_str());
  def_fields<T>(one);
  if constexpr (requires { Fields<T>::kOffsets; }) {
    one.rows(Fields<T>::kOffsets, Fields<T>::kValues);
  }
  if constexpr (requires { &T::size; }) {
    one.entries();
  }
  return one;
}

/// The class of T's batch.
template <class T>
AnswerClass<BatchOf<T>> bind_batch(py::module_& module) {
  AnswerClass<BatchOf<T>> batch(module, Fields<T>::kBatchName, Fields<T>::kBatchMeaning);
  def_columns<T>(batch);
  batch.entries();
  return batch;
}

/// Both.
template <class T>
void bind_answers_of(py::module_& module) {
  bind_answer<T>(module);
  bind_batch<T>(module);
}

}  // namespace soms::python
