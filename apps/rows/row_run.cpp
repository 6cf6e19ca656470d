#include "apps/rows/row_run.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/text.h"
#include "apps/output/block_size.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace soms::command {

RowRun::RowRun(RowRunOptions options, Console& console)
    : options_(std::move(options)), console_(console) {
  if (options_.has_files || options_.verify || options_.fail_if_found) {
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
    doubt();
  }
  if (!interrupted || totals_.rows > 0) {
    finish(interrupted ? End::interrupted : late_ ? End::out_of_time : End::complete);
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
    begin();
    BlockSize size;
    while (!over_) {
      const auto begin = std::chrono::steady_clock::now();
      read_block(size.value());
      const std::uint64_t held = answer_block();
      print_block();
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
  clear_block();
  in_block_ = 0;
  try {
    while (in_block_ < size && (in_block_ == 0 || ready())) {
      if (!read_row()) {
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

void RowRun::print_block() {
  for (std::size_t k = 0; k < in_block_; ++k) {
    bool right = true;
    try {
      right = !options_.verify || verify(k);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::timed_out || totals_.rows == 0) {
        throw;
      }
      end_by_time();
      break;
    }
    const Outcome known = outcome(k);
    const bool last = known.cut && console_.out_of_time();
    print_row(k, right, last);
    ++totals_.rows;
    totals_.found += known.found ? 1U : 0U;
    totals_.undecided += known.undecided ? 1U : 0U;
    if (last) {
      end_by_time();
      break;
    }
  }
  if (starved_ && !late_) {
    end_by_time();
  }
  console_.flush();
  show_progress(0);
}

void RowRun::end_by_time() {
  late_ = true;  // rows may be left
  console_.note(fmt::format("out of time after {}", counted(totals_.rows, options_.noun)));
  over_ = true;
  error_ = nullptr;  // a faulty row was read ahead, but not reached
}

bool RowRun::verify(std::size_t k) {
  const std::optional<std::string> found = difference(k);
  if (found) {
    ++totals_.wrong;
    print_error("soms " + options_.verb, fmt::format("{} {}: {}", options_.noun, number(), *found));
  }
  return !found;
}

void RowRun::show_progress(double share) {
  const bool perhaps_alone = totals_.rows == 0 && in_block_ == 1;
  if (is_single() || perhaps_alone) {
    bar_->show(share);
  } else {
    bar_->show(counted(totals_.rows, options_.noun));
  }
}

void RowRun::print_end() {
  print_totals();
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
