/// \file
/// A question that is put to rows of input: what a verb adds to where rows come from (`Rows`) and
/// where answers go (`Sinks`).
#pragma once

#include "apps/cli/terminal.h"
#include "apps/output/json.h"
#include "apps/output/npz_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>

namespace soms::command {

class CsvFile;
class JsonRows;

/// How the rows were answered so far.
struct RowTotals {
  std::uint64_t rows = 0;
  std::uint64_t found = 0;      ///< the condition of --fail-if holds for them
  std::uint64_t undecided = 0;  ///< cut before it was known whether it holds
  std::uint64_t wrong = 0;      ///< differ from brute force
};

/// A row that is answered, and about to be reported.
struct AnsweredRow {
  std::size_t k = 0;         ///< in its block
  std::uint64_t number = 0;  ///< rows of the input before it
  bool right = true;         ///< false where brute force differs
  bool last = false;         ///< time ended in this row
};

/// What is known of a row that is answered.
struct RowOutcome {
  bool found = false;
  bool undecided = false;
  bool cut = false;  ///< by the clock, if time is up
};

/// Shows how far the only row of a block has come.
using ShowProgress = std::function<void(double share)>;

/// The answers are those of the block that was answered last; `k` is a row of it.
class Question {
 public:
  Question() = default;
  Question(const Question&) = delete;
  Question& operator=(const Question&) = delete;
  virtual ~Question() = default;

  /// Where `sentence` and `text` are shown.
  void show_on(const Terminal& terminal) { terminal_ = terminal; }

  /// Answers the rows of the block. Returns how many things the answers hold, where these may take
  /// much memory.
  virtual std::uint64_t answer(const ShowProgress& show) = 0;

  [[nodiscard]] virtual RowOutcome outcome(std::size_t k) const = 0;

  /// What brute force finds otherwise; nothing if it agrees. \errors ErrorKind::timed_out.
  [[nodiscard]] virtual std::optional<std::string> difference(std::size_t k) = 0;

  /// Called once for each row that is reported, before it is. \errors ErrorKind::cancelled.
  virtual void count(const AnsweredRow& /*row*/) {}

  /// Writes the row as JSON.
  virtual void json(const AnsweredRow& row, JsonRows& rows) const = 0;

  /// An object behind the rows of JSON; null for none.
  [[nodiscard]] virtual Json json_totals() const { return nullptr; }

  /// The answer of the only row as text, with a line break.
  [[nodiscard]] virtual std::string sentence(std::size_t /*k*/) const { return {}; }

  /// The line above the table of rows that people read, if there is one; and a row of it. Both have
  /// a line break.
  [[nodiscard]] virtual std::string text_head() const { return {}; }

  [[nodiscard]] virtual std::string text(const AnsweredRow& row) const = 0;

  /// Rows of text: as many as a person may want to read; and a line about so many "poses" more.
  [[nodiscard]] virtual std::uint64_t most_text() const { return 20; }

  [[nodiscard]] virtual std::string left_out(const std::string& rows) const {
    return "   and " + rows + " more; --json lists all\n";
  }

  /// Behind the text of all rows, with a line break.
  [[nodiscard]] virtual std::string totals(const RowTotals& totals) const = 0;

  /// Names of the columns of CSV, and the lines of a row.
  [[nodiscard]] virtual std::string csv_head() const = 0;
  virtual void csv(const AnsweredRow& row, CsvFile& file) const = 0;

  /// Adds columns to a file, which must stay; and the answers of the first rows of the block.
  virtual void begin_columns(NpzFile& /*file*/) {}

  virtual void add_columns(std::size_t /*rows*/) {}

  /// Begins a page, adds a row to it, and writes it.
  virtual void begin_page() {}

  virtual void add_to_page(const AnsweredRow& /*row*/) {}

  virtual void write_page(std::ostream& /*out*/, const RowTotals& /*totals*/) const {}

 protected:
  [[nodiscard]] const Terminal& terminal() const { return terminal_; }

  /// Digits of numbers in the table.
  [[nodiscard]] int digits() const { return terminal_.digits(); }

  /// The verdict that `words` begin with, up to a colon or parenthesis, in its color.
  [[nodiscard]] std::string painted(std::string words, const RowOutcome& outcome) const {
    const std::size_t end = std::min(words.find_first_of(":(\n"), words.size());
    return terminal_.paint(words.substr(0, end), ink_of(outcome.found, outcome.undecided)) +
           words.substr(end);
  }

 private:
  Terminal terminal_;
};

}  // namespace soms::command
