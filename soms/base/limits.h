/// \file
/// How much of the machine and how much time a call may use, how it is stopped, and how it reports
/// progress.
#pragma once

#include "soms/base/stop_token.h"

#include <chrono>
#include <functional>
#include <optional>

namespace soms {

/// Threads, cancellation, time and progress of one call. The default is one thread, no way to stop,
/// no deadline, no reports. Results are the same bytes for any number of threads.
struct Limits {
  /// Worker threads, the caller's included; 0 means one for each processor.
  int threads = 1;
  /// Ends the call with ErrorKind::cancelled soon after a stop is requested.
  StopToken stop = {};
  /// Ends the call soon after it passes. An answer that has a `coverage` says `cut`, and what it
  /// holds is proved. Other calls end with ErrorKind::timed_out.
  std::optional<std::chrono::steady_clock::time_point> deadline = std::nullopt;
  /// Called now and then with the share done, 0 to 1, by one thread at a time; may be empty.
  std::function<void(double)> progress = {};

  /// The same on the caller's thread alone, without reports: for a part of the work.
  [[nodiscard]] Limits alone() const { return {.threads = 1, .stop = stop, .deadline = deadline}; }

  /// The same without reports.
  [[nodiscard]] Limits silent() const {
    return {.threads = threads, .stop = stop, .deadline = deadline};
  }

  /// The same without a deadline: for what must be complete.
  [[nodiscard]] Limits without_deadline() const {
    return {.threads = threads, .stop = stop, .progress = progress};
  }

  /// The deadline passed.
  [[nodiscard]] bool late() const {
    return deadline && std::chrono::steady_clock::now() >= *deadline;
  }
};

/// Throws ErrorKind::cancelled if a stop was requested, timed_out if the deadline passed.
void check(const Limits& limits);

/// Throws ErrorKind::cancelled if a stop was requested: for queries whose answers have a coverage.
void check_stop(const Limits& limits);

}  // namespace soms
