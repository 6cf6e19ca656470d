/// \file
/// Answers on their way to JavaScript: columns of numbers that the caller copies.
#pragma once

#include "soms/base/error.h"
#include "soms/base/vector.h"
#include "soms/describe/columns.h"
#include "soms/query/answer.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace soms::web {

/// What a column's numbers are.
enum class Numbers : std::uint32_t { u8, u32, i32, f64 };

/// Columns in an order that the query's function states. They live as long as the answer.
class Answer {
 public:
  struct Column {
    const void* data;
    std::uint32_t count;
    Numbers numbers;
  };

  void add(std::vector<std::uint8_t> rows) { hold(std::move(rows), 1, Numbers::u8); }

  void add(std::vector<std::uint32_t> rows) { hold(std::move(rows), 1, Numbers::u32); }

  void add(std::vector<double> rows) { hold(std::move(rows), 1, Numbers::f64); }

  void add(std::vector<Vec3> rows) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    hold(std::move(rows), 3, Numbers::f64);
  }

  void add(std::vector<TrianglePair> rows) {
    static_assert(sizeof(TrianglePair) == 2 * sizeof(std::uint32_t));
    hold(std::move(rows), 2, Numbers::u32);
  }

  /// Offsets of rows: as many as fit into the module's memory.
  void add(const std::vector<std::uint64_t>& rows) {
    add(std::vector<std::uint32_t>(rows.begin(), rows.end()));
  }

  /// Codes of an enumeration, in the order in which it is declared.
  template <class Enum>
  void add(const std::vector<Enum>& rows) requires std::is_enum_v<Enum> {
    std::vector<std::uint8_t> codes(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      codes[i] = static_cast<std::uint8_t>(rows[i]);
    }
    add(std::move(codes));
  }

  /// Triangles, -1 for none.
  void add(const std::vector<std::optional<TriangleId>>& rows) {
    std::vector<std::int32_t> numbers(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      numbers[i] = rows[i] ? static_cast<std::int32_t>(*rows[i]) : -1;
    }
    hold(std::move(numbers), 1, Numbers::i32);
  }

  /// Pairs of triangles, twice -1 for none.
  void add(const std::vector<std::optional<TrianglePair>>& rows) {
    std::vector<std::int32_t> numbers(2 * rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      numbers[2 * i] = rows[i] ? static_cast<std::int32_t>(rows[i]->a) : -1;
      numbers[2 * i + 1] = rows[i] ? static_cast<std::int32_t>(rows[i]->b) : -1;
    }
    hold(std::move(numbers), 1, Numbers::i32);
  }

  /// Vectors, NaN for none.
  void add(const std::vector<std::optional<Vec3>>& rows) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> vectors(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      vectors[i] = rows[i].value_or(Vec3{kNone, kNone, kNone});
    }
    add(std::move(vectors));
  }

  /// Node tests, triangle tests, exact tests.
  void add(const Cost& cost) {
    add(std::vector<double>{static_cast<double>(cost.node_tests),
                            static_cast<double>(cost.triangle_tests),
                            static_cast<double>(cost.exact_tests)});
  }

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

 private:
  template <class Row>
  void hold(std::vector<Row> rows, std::size_t width, Numbers numbers) {
    const auto held = std::make_shared<const std::vector<Row>>(std::move(rows));
    columns_.push_back({held->data(), static_cast<std::uint32_t>(held->size() * width), numbers});
    owners_.push_back(held);
  }

  std::vector<Column> columns_;
  std::vector<std::shared_ptr<const void>> owners_;
};

/// An answer with these columns; `soms_answer_free` ends it.
template <class... Columns>
[[nodiscard]] Answer* answer_of(Columns&&... columns) {
  auto answer = std::make_unique<Answer>();
  (answer->add(std::forward<Columns>(columns)), ...);
  return answer.release();
}

/// Adds the columns of a batch, by the fields of answers T; its costs only together, and last.
template <Described T>
void add_columns(Answer& answer, BatchOf<T>& batch) {
  detail::for_each_column<T>([&](auto column, const auto& /*get*/, const auto& /*set*/) {
    if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(batch.*column)>,
                                  std::vector<Cost>>) {
      answer.add(std::move(batch.*column));
    }
  });
  answer.add(batch.cost);
}

/// An answer with the columns of a batch.
template <Described T>
[[nodiscard]] Answer* answer_of_batch(BatchOf<T> batch) {
  auto answer = std::make_unique<Answer>();
  add_columns<T>(*answer, batch);
  return answer.release();
}

/// An answer with all lists of T, and what it cost.
template <Described T>
[[nodiscard]] Answer* answer_of_lists(T lists) {
  auto answer = std::make_unique<Answer>();
  for_each_field<T>([&](const auto& field) {
    if constexpr (!std::is_same_v<typename std::remove_cvref_t<decltype(field)>::Type,
                                  std::vector<Cost>>) {
      answer->add(std::move(lists.*(field.place)));
    }
  });
  return answer.release();
}

}  // namespace soms::web
