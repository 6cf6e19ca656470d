/// \file
/// Rows of input, answered in blocks and reported in their order, whatever the question is.
#pragma once

#include "apps/cli/progress.h"
#include "apps/rows/question.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

namespace soms::command {

class Console;
class Sinks;

/// How a run ended.
enum class RunEnd { complete, out_of_time, interrupted };

/// Rows of a block, and where they come from.
class Rows {
 public:
  Rows() = default;
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  virtual ~Rows() = default;

  /// Before the first row is read.
  virtual void begin() {}

  /// True if there is one row, it is known that there is, and it is reported at length.
  [[nodiscard]] virtual bool is_single() const { return false; }

  /// False if rows are not printed as text.
  [[nodiscard]] virtual bool are_listed() const { return true; }

  /// Begins a block.
  virtual void clear() = 0;
  /// True if `read` will not wait.
  virtual bool ready() = 0;
  /// Adds the next row to the block; false at the end.
  virtual bool read() = 0;

  /// Before a row is reported.
  virtual void report(const AnsweredRow& /*row*/) {}

  /// Says what is doubtful of all rows together, once they are printed and not interrupted.
  virtual void doubt() {}

  /// False if the files of answers shall not appear.
  virtual bool end(RunEnd /*end*/) { return true; }

  /// Once they have.
  virtual void finish() {}
};

/// What a run over rows is called, and how it ends.
struct RowRunOptions {
  std::string verb;  ///< as messages name it
  std::string noun;  ///< what a row is called: "pose"
  bool verify = false;
  bool fail_if_found = false;
  std::uint64_t first = 0;  ///< rows of the input before the first one
};

/// Reads rows in blocks, answers each block, and reports its rows in order. Ctrl-C and --timeout
/// end it between two rows, or within one, with what is answered by then. Where nobody reads
/// standard output any more, the run goes on for its files and its exit status, if it has any.
class RowRun {
 public:
  RowRun(RowRunOptions options, Rows& rows, Question& question, Sinks& sinks, Console& console);

  /// Answers every row; the exit status.
  /// \errors Those of the rows and of their answers, after the rows before are printed;
  ///         ErrorKind::cancelled for Ctrl-C.
  int run();

 private:
  [[nodiscard]] std::string answered() const;
  bool answer_all();
  void read_block(std::size_t size);
  void report_block();
  void report_rows(std::size_t& reported);
  [[nodiscard]] bool verify(std::size_t k);
  void show_progress(double share);
  void end_by_time();
  void print_end();
  [[nodiscard]] int status() const;

  RowRunOptions options_;
  Rows& rows_;
  Question& question_;
  Sinks& sinks_;
  Console& console_;
  Progress* bar_ = nullptr;  ///< while it runs
  RowTotals totals_;
  std::size_t in_block_ = 0;  ///< rows
  std::exception_ptr error_;
  bool over_ = false;
  bool starved_ = false;  ///< time ended while a row was waited for
  bool late_ = false;
};

}  // namespace soms::command
