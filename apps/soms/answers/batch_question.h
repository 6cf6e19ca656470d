/// \file
/// Questions whose answers are columns, which stay columns on their way into files.
#pragma once

#include "soms/describe/columns.h"
#include "soms/query/answer.h"

#include "apps/model/file_numbers.h"
#include "apps/rows/csv_file.h"
#include "apps/rows/json_rows.h"
#include "apps/rows/question.h"
#include "apps/soms/answers/answer_fields.h"
#include "apps/soms/pairs/pair_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace soms::command {

/// The object of a row: its keys each follow a comma.
[[nodiscard]] inline std::string json_row(const std::string& verb, const std::string& key,
                                          const AnsweredRow& row, const std::string& keys) {
  return fmt::format("{{\"schema\":\"soms.{}/2\",\"{}\":{}{}}}", verb, key, row.number, keys);
}

/// The answers T of a block; `key` is what JSON and CSV call the number of a row.
template <Described T>
class BatchQuestion : public Question {
 public:
  BatchQuestion(std::string verb, std::string key) : verb_(std::move(verb)), key_(std::move(key)) {}

  void json(const AnsweredRow& row, JsonRows& rows) const override {
    const T answer = shown(row.k);
    rows.put(json_row(verb_, key_, row,
                      lead_keys(answer) + field_keys(answer) + more_keys(row.k) +
                          coverage_keys(answer.coverage, answer.cost) + row_keys(row)));
    rows.end_row();
  }

  [[nodiscard]] std::string csv_head() const override {
    return key_ + lead_head() + "," + field_head<T>() + more_head();
  }

  void csv(const AnsweredRow& row, CsvFile& file) const override {
    std::string& line = file.line();
    fmt::format_to(std::back_inserter(line), "{}{},", row.number, lead_cells(row.k));
    add_field_cells(
        shown(row.k), [this](int side, auto triangle) { return triangle_cells(side, triangle); },
        line);
    line += more_cells(row.k);
    file.end_line();
  }

  void begin_columns(NpzFile& file) override { columns_.template begin<T>(file); }

  void add_columns(std::size_t rows) override {
    if (numbers(0).are_the_same() && numbers(1).are_the_same()) {
      columns_.template add<T>(batch_, rows);
      return;
    }
    BatchOf<T> named = batch_;
    for (std::size_t k = 0; k < rows; ++k) {
      put_columns(shown(k), k, named);
    }
    columns_.template add<T>(named, rows);
  }

  [[nodiscard]] RowOutcome outcome(std::size_t k) const override {
    const T answer = at(k);
    return {.found = found(answer),
            .undecided = undecided(answer),
            .cut = answer.coverage == Coverage::cut};
  }

 protected:
  [[nodiscard]] T at(std::size_t k) const { return row_of<T>(batch_, k); }

  /// The same as it is written: triangles have the numbers of their files.
  [[nodiscard]] T shown(std::size_t k) const {
    T answer = at(k);
    if constexpr (requires { answer.triangles.has_value(); }) {
      if (answer.triangles) {
        answer.triangles = in_files(numbers(0), numbers(1), *answer.triangles);
      }
    } else if constexpr (requires { answer.triangle.has_value(); }) {
      if (answer.triangle) {
        answer.triangle = numbers(0)(*answer.triangle);
      }
    }
    return answer;
  }

  /// From numbers of the first or second model to those of its file.
  [[nodiscard]] virtual const FileNumbers& numbers(int /*side*/) const {
    static const FileNumbers same;
    return same;
  }

  /// All answers of the block.
  void set(BatchOf<T> batch) { batch_ = std::move(batch); }

  /// Makes room for as many answers; `put` writes them, each entry from one thread.
  void reserve(std::size_t rows) {
    batch_ = {};
    resize_columns<T>(batch_, rows);
  }

  void put(std::size_t begin, const T& answer) { put_columns(answer, begin, batch_); }

  void put(std::size_t begin, const BatchOf<T>& part) {
    soms::detail::for_each_column<T>([&](auto column, const auto&, const auto&) {
      std::copy((part.*column).begin(), (part.*column).end(),
                (batch_.*column).begin() + static_cast<std::ptrdiff_t>(begin));
    });
  }

  [[nodiscard]] virtual bool found(const T& answer) const = 0;
  [[nodiscard]] virtual bool undecided(const T& answer) const = 0;

  /// Keys of JSON before and behind the fields, and behind the costs; each follows a comma.
  [[nodiscard]] virtual std::string lead_keys(const T& /*answer*/) const { return {}; }

  [[nodiscard]] virtual std::string more_keys(std::size_t /*k*/) const { return {}; }

  [[nodiscard]] virtual std::string row_keys(const AnsweredRow& row) const = 0;

  /// Further cells of CSV, before and behind those of the fields, and what they are called. Each
  /// follows a comma.
  [[nodiscard]] virtual std::string lead_head() const { return {}; }

  [[nodiscard]] virtual std::string lead_cells(std::size_t /*k*/) const { return {}; }

  [[nodiscard]] virtual std::string more_head() const { return {}; }

  [[nodiscard]] virtual std::string more_cells(std::size_t /*k*/) const { return {}; }

  /// The three cells of a triangle of the only body, or of both.
  [[nodiscard]] virtual std::string triangle_cells(int /*side*/,
                                                   std::optional<TriangleId> /*triangle*/) const {
    return {};
  }

 private:
  std::string verb_;
  std::string key_;
  BatchOf<T> batch_;
  FieldColumns columns_;
};

}  // namespace soms::command
