/// \file
/// Rows of input, answered in blocks and printed in their order, whatever the question is.
#pragma once

#include "apps/cli/progress.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>

namespace soms::command {

class Console;

/// How the rows were answered so far.
struct RowTotals {
  std::uint64_t rows = 0;
  std::uint64_t found = 0;      ///< the condition of --fail-if holds for them
  std::uint64_t undecided = 0;  ///< cut before it was known whether it holds
  std::uint64_t wrong = 0;      ///< differ from brute force
};

/// What a run over rows is called, and how it ends.
struct RowRunOptions {
  std::string verb;  ///< as messages name it
  std::string noun;  ///< what a row is called: "pose"
  bool verify = false;
  bool fail_if_found = false;
  bool has_files = false;  ///< answers go to files, too
};

/// Reads rows in blocks, answers each block, and prints its rows in order. Ctrl-C and --timeout end
/// it between two rows, or within one, with what is answered by then. Where nobody reads standard
/// output any more, the run goes on for its files and its exit status, if it has any. A verb
/// derives from it and says how to read, answer, verify and print.
class RowRun {
 public:
  virtual ~RowRun() = default;
  RowRun(const RowRun&) = delete;
  RowRun& operator=(const RowRun&) = delete;

  /// Answers every row; the exit status.
  /// \errors Those of the rows and of their answers, after the rows before are printed;
  ///         ErrorKind::cancelled for Ctrl-C.
  int run();

 protected:
  /// What is known of a row that is answered.
  struct Outcome {
    bool found = false;
    bool undecided = false;
    bool cut = false;  ///< by the clock, if time is up
  };

  /// How the run ended.
  enum class End { complete, out_of_time, interrupted };

  RowRun(RowRunOptions options, Console& console);

  [[nodiscard]] Console& console() const { return console_; }

  [[nodiscard]] const RowTotals& totals() const { return totals_; }

  /// What the row that is printed next is called: how many rows come before it in the input.
  [[nodiscard]] std::uint64_t number() const { return first_ + totals_.rows; }

  /// The first row of the run is not that of the input.
  void begin_at(std::uint64_t first) { first_ = first; }

  /// Shows how far the only row has come; of many rows, how many are answered.
  void show_progress(double share);

 private:
  /// Before the first row is read.
  virtual void begin() = 0;
  /// True if there is one row, and it is known that there is.
  [[nodiscard]] virtual bool is_single() const = 0;
  virtual void clear_block() = 0;
  /// True if `read_row` will not wait.
  virtual bool ready() = 0;
  /// Adds the next row to the block; false at the end.
  virtual bool read_row() = 0;
  /// Answers the rows of the block. Returns how many things their answers hold, where these may
  /// take much memory.
  virtual std::uint64_t answer_block() = 0;
  /// Row `k` of the block, of which there is an answer.
  [[nodiscard]] virtual Outcome outcome(std::size_t k) const = 0;
  /// What brute force finds otherwise; nothing if it agrees. \errors ErrorKind::timed_out.
  [[nodiscard]] virtual std::optional<std::string> difference(std::size_t k) = 0;
  /// Prints row `number()`. `right` is false where brute force differs; `last` is true
  /// where time ended in this row.
  virtual void print_row(std::size_t k, bool right, bool last) = 0;
  /// Prints a line over all rows, where there may be several. Not called with --json.
  virtual void print_totals() = 0;
  /// Says what is doubtful of all rows together, once they are printed and not interrupted.
  virtual void doubt() = 0;
  /// Finishes the files of answers.
  virtual void finish(End end) = 0;

  [[nodiscard]] std::string answered() const;
  bool answer_all();
  void read_block(std::size_t size);
  void print_block();
  bool verify(std::size_t k);
  void end_by_time();
  void print_end();
  [[nodiscard]] int status() const;

  RowRunOptions options_;
  Console& console_;
  Progress* bar_ = nullptr;  ///< while it runs
  RowTotals totals_;
  std::uint64_t first_ = 0;
  std::size_t in_block_ = 0;  ///< rows
  std::exception_ptr error_;
  bool over_ = false;
  bool starved_ = false;  ///< time ended while a row was waited for
  bool late_ = false;
};

}  // namespace soms::command
