/// \file
/// `<<` of whatever has a list of fields: "Within{within: true, ...}"; and of batches:
/// "WithinBatch{1 of 2 poses within the clearance, ...}".
#pragma once

#include "soms/base/print.h"
#include "soms/base/print_fields.h"
#include "soms/describe/fields.h"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms {

namespace detail {

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;

template <class Value>
void print_field(const char* name, const Value& value, PrintedFields& fields) {
  if constexpr (kIsOptional<Value>) {
    if (value) {
      print_field(name, *value, fields);
    }
  } else if constexpr (kIsVector<Value>) {
    const std::string_view many = name;  // a plural
    fields.item(printed_count(value.size(), many.substr(0, many.size() - 1), many));
  } else if constexpr (requires { value.a, value.b; }) {  // two triangles
    fields.item(std::string(name) + " " + std::to_string(value.a) + " and " +
                std::to_string(value.b));
  } else {
    fields.add(name, value);
  }
}

/// Whether a field says nothing.
template <class T>
[[nodiscard]] bool is_silent(const auto& field, const T& value) {
  if (field.of_triangle && !names_triangle(value)) {
    return true;
  }
  // Not a temporary: g++ 12 takes the empty optionals of one for uninitialized.
  static const T standard{};
  return field.unless_default && field.of(value) == field.of(standard);
}

template <Described T>
void print_own_fields(const T& value, PrintedFields& fields) {
  std::apply(
      [&](const auto&... field) {
        ((is_silent(field, value) ? void() : print_field(field.name, field.of(value), fields)),
         ...);
      },
      Fields<T>::kList);
}

/// The answer that a batch has at an entry.
template <class Batch>
using EntryOf = std::remove_cvref_t<decltype(std::declval<const Batch&>().at(std::size_t{}))>;

/// A batch whose rows have a name, and that is not one of answers with more.
template <class Batch>
concept NamedBatch = requires(const Batch& batch) {
  batch.at(std::size_t{});
  batch.cost;
  requires std::same_as<typename Fields<EntryOf<Batch>>::Batch, Batch>;
  Fields<EntryOf<Batch>>::kRows;
  requires !requires {
    typename Fields<EntryOf<Batch>>::Base;
  };
};

}  // namespace detail

/// Lists are counted, not listed; what says nothing is left out. An answer about one of many bodies
/// begins with it.
template <Described T>
std::ostream& operator<<(std::ostream& out, const T& value) {
  PrintedFields fields(Fields<T>::kName);
  detail::print_own_fields(value, fields);
  if constexpr (requires { typename Fields<T>::Base; }) {
    fields.item(printed(static_cast<const typename Fields<T>::Base&>(value)));
  }
  return out << fields;
}

/// Entries are counted, not listed: all, or those of which Fields<T>::kCounted holds.
template <detail::NamedBatch Batch>
std::ostream& operator<<(std::ostream& out, const Batch& batch) {
  using List = Fields<detail::EntryOf<Batch>>;
  PrintedFields fields(List::kBatchName);
  const std::string_view rows = List::kRows;
  const std::string entries =
      printed_count(batch.size(), rows.substr(0, rows.size() - 1), rows);  // a plural
  if constexpr (requires { List::kCounted; }) {
    std::string text;
    for (const auto& counted : List::kCounted) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < batch.size(); ++i) {
        if (counted.holds(batch.at(i))) {
          ++count;
        }
      }
      text += (text.empty() ? "" : ", ") + std::to_string(count) +
              (text.empty() ? " of " + entries : "") + " " +
              (batch.size() == 1 ? counted.words_of_one : counted.words);
    }
    fields.item(text);
  } else {
    fields.item(entries);
  }
  if constexpr (requires { List::kCoverage; }) {
    const auto& coverage = batch.*List::kCoverage;
    using Covered = typename std::remove_cvref_t<decltype(coverage)>::value_type;
    const bool cut = std::find(coverage.begin(), coverage.end(), Covered::cut) != coverage.end();
    fields.add("coverage", cut ? Covered::cut : Covered::complete);
  }
  return out << fields.add("cost", batch.cost);
}

}  // namespace soms
