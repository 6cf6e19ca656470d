#include "apps/rows/row_run.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/text.h"
#include "apps/output/block_size.h"
#include "apps/rows/sinks.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace soms::command {

RowRun::RowRun(RowRunOptions options, Rows& rows, Question& question, Sinks& sinks,
               Console& console)
    : options_(std::move(options)),
      rows_(rows),
      question_(question),
      sinks_(sinks),
      console_(console) {
  question_.show_on(console_.terminal());
  if (sinks_.has_files() || options_.verify || options_.fail_if_found) {
    console_.go_on_without_reader();
  }
}

int RowRun::run() {
  Progress bar = console_.progress(options_.verb);
  bar_ = &bar;
  const bool interrupted = !answer_all();
  if (((!interrupted && !error_) || totals_.rows > 0) && !console_.shared().json) {
    print_end();
  }
  console_.flush();
  if (error_) {
    std::rethrow_exception(error_);
  }
  if (totals_.wrong == 0 && !interrupted) {
    rows_.doubt();
  }
  if (!interrupted || totals_.rows > 0) {
    const RunEnd end = interrupted ? RunEnd::interrupted
                       : late_     ? RunEnd::out_of_time
                                   : RunEnd::complete;
    if (rows_.end(end)) {
      sinks_.finish(question_, totals_);
      rows_.finish();
    }
  }
  if (interrupted) {
    throw Error(ErrorKind::cancelled, "interrupted", answered() + " answered");
  }
  return status();
}

std::string RowRun::answered() const {
  return fmt::format("{} {}", counted(totals_.rows, options_.noun),
                     totals_.rows == 1 ? "is" : "are");
}

/// False if it was interrupted.
bool RowRun::answer_all() {
  try {
    sinks_.begin(question_);
    rows_.begin();
    const ShowProgress show = [this](double share) { show_progress(share); };
    BlockSize size;
    while (!over_) {
      const auto begin = std::chrono::steady_clock::now();
      read_block(size.value());
      const std::uint64_t held = question_.answer(show);
      report_block();
      size.learn(std::chrono::steady_clock::now() - begin, held);
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::cancelled) {
      throw;
    }
    error_ = nullptr;  // a faulty row was read ahead, but not reached
    return false;
  }
  return true;
}

/// A faulty row ends the reading, as the end of time does; the rows before it are answered first,
/// and also before a row that is not there yet: its writer may wait for the answers.
void RowRun::read_block(std::size_t size) {
  rows_.clear();
  in_block_ = 0;
  try {
    while (in_block_ < size && (in_block_ == 0 || rows_.ready())) {
      if (!rows_.read()) {
        over_ = true;
        return;
      }
      ++in_block_;
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      throw;
    }
    over_ = true;
    starved_ = error.kind() == ErrorKind::timed_out && totals_.rows + in_block_ > 0;
    error_ = starved_ ? nullptr : std::current_exception();
  }
}

void RowRun::report_block() {
  std::size_t reported = 0;
  try {
    report_rows(reported);
  } catch (...) {
    sinks_.add_columns(question_, reported);
    throw;
  }
  sinks_.add_columns(question_, reported);
  if (starved_ && !late_) {
    end_by_time();
  }
  console_.flush();
  show_progress(0);
}

void RowRun::report_rows(std::size_t& reported) {
  for (std::size_t k = 0; k < in_block_; ++k) {
    bool right = true;
    try {
      right = !options_.verify || verify(k);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::timed_out || totals_.rows == 0) {
        throw;
      }
      end_by_time();
      return;
    }
    const RowOutcome known = question_.outcome(k);
    const bool last = known.cut && console_.out_of_time();
    const AnsweredRow row{k, options_.first + totals_.rows, right, last};
    rows_.report(row);
    question_.count(row);
    sinks_.add(question_, row, rows_.is_single(), rows_.are_listed());
    ++reported;
    ++totals_.rows;
    totals_.found += known.found ? 1U : 0U;
    totals_.undecided += known.undecided ? 1U : 0U;
    if (last) {
      end_by_time();
      return;
    }
  }
}

void RowRun::end_by_time() {
  late_ = true;  // rows may be left
  console_.note(fmt::format("out of time after {}", counted(totals_.rows, options_.noun)));
  over_ = true;
  error_ = nullptr;  // a faulty row was read ahead, but not reached
}

bool RowRun::verify(std::size_t k) {
  const std::optional<std::string> found = question_.difference(k);
  if (found) {
    ++totals_.wrong;
    print_error("soms " + options_.verb,
                fmt::format("{} {}: {}", options_.noun, options_.first + totals_.rows, *found));
  }
  return !found;
}

void RowRun::show_progress(double share) {
  const bool perhaps_alone = totals_.rows == 0 && in_block_ == 1;
  if (rows_.is_single() || perhaps_alone) {
    bar_->show(share);
  } else {
    bar_->show(counted(totals_.rows, options_.noun));
  }
}

void RowRun::print_end() {
  if (!rows_.is_single()) {
    sinks_.print_totals(question_, totals_, options_.noun);
  }
  if (options_.verify) {
    console_.print(fmt::format("verified by brute force: {} of {} equal\n",
                               with_commas(totals_.rows - totals_.wrong),
                               counted(totals_.rows, "answer")));
  }
}

int RowRun::status() const {
  if (totals_.wrong != 0) {
    return kDifference;
  }
  if (options_.fail_if_found && totals_.found != 0) {
    return kConditionHolds;
  }
  // "Not found" is no proof that there is nothing when time ran out.
  return options_.fail_if_found && (totals_.undecided != 0 || late_) ? kOutOfTime : 0;
}

}  // namespace soms::command
