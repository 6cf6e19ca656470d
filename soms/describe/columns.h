/// \file
/// Columns of batches, by the fields of their answers.
#pragma once

#include "soms/describe/fields.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms {

/// The batch of answers T.
template <Described T>
using BatchOf = typename Fields<T>::Batch;

namespace detail {

template <class Column>
struct ColumnTraits {
  static constexpr bool kIsVector = false;  // NoColumn, or one value of all rows
};

template <class Batch, class Value>
struct ColumnTraits<std::vector<Value> Batch::*> {
  static constexpr bool kIsVector = true;
};

/// Calls `function(column, get, set)` for each vector of a batch that is written from T, with how
/// its entries are read from an answer and written to one.
template <Described T, class Function>
constexpr void for_each_column(Function&& function) {
  for_each_field<T>([&](const auto& field) {
    using F = std::remove_cvref_t<decltype(field)>;
    using Column = decltype(field.column);
    const auto place = field.place;
    if constexpr (std::is_same_v<typename F::Type, Bracket> && !ColumnTraits<Column>::kIsVector) {
      function(
          field.column.lower, [place](const T& answer) { return (answer.*place).lower; },
          [place](T& answer, double value) { (answer.*place).lower = value; });
      function(
          field.column.upper, [place](const T& answer) { return (answer.*place).upper; },
          [place](T& answer, double value) { (answer.*place).upper = value; });
    } else if constexpr (std::is_same_v<typename F::Type, bool>) {
      function(
          field.column,
          [place](const T& answer) { return static_cast<std::uint8_t>(answer.*place ? 1 : 0); },
          [place](T& answer, std::uint8_t value) { answer.*place = value != 0; });
    } else if constexpr (ColumnTraits<Column>::kIsVector) {
      function(
          field.column, [place](const T& answer) -> const auto& { return answer.*place; },
          [place](T& answer, const auto& value) { answer.*place = value; });
    }
  });
}

}  // namespace detail

/// Gives all columns `size` entries. What is new in them is an answer that was not begun.
template <Described T>
void resize_columns(BatchOf<T>& batch, std::size_t size) {
  const T empty{};
  detail::for_each_column<T>([&](auto column, const auto& get, const auto& /*set*/) {
    (batch.*column).resize(size, get(empty));
  });
}

/// Writes an answer to entry i of all columns. \pre They have it.
template <Described T>
void put_columns(const T& answer, std::size_t i, BatchOf<T>& batch) {
  detail::for_each_column<T>(
      [&](auto column, const auto& get, const auto& /*set*/) { (batch.*column)[i] = get(answer); });
}

/// The answer that entry i of all columns holds. \pre They have it.
template <Described T>
[[nodiscard]] T row_of(const BatchOf<T>& batch, std::size_t i) {
  T answer{};
  detail::for_each_column<T>(
      [&](auto column, const auto& /*get*/, const auto& set) { set(answer, (batch.*column)[i]); });
  return answer;
}

/// What all answers of a batch cost together is known now.
template <Described T>
void sum_costs(BatchOf<T>& batch) {
  batch.cost = {};
  for (const auto& cost : batch.costs) {
    batch.cost += cost;
  }
}

}  // namespace soms
