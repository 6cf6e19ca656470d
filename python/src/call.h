/// \file
/// A call into the library: the interpreter's lock is free, Ctrl-C ends it, progress is reported.
#pragma once

#include "soms/base/limits.h"

#include "python/src/errors.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <utility>

namespace soms::python {

/// How much work a call may be.
enum class Work {
  one,   ///< a query of one pose or point: what is spent on the call itself counts
  many,  ///< a batch, a build, a file
};

/// How many threads a call may use, and how long.
struct CallLimits {
  CallLimits(int threads_allowed) : threads(threads_allowed) {}  // NOLINT: one without a deadline

  /// `timeout` in seconds from now on. \errors ErrorKind::usage unless it is a number from 0 on.
  CallLimits(int threads_allowed, const std::optional<double>& timeout);

  int threads;
  std::optional<std::chrono::steady_clock::time_point> deadline = std::nullopt;
};

/// `timeout`, or what was given by its old name, `seconds`, with a DeprecationWarning.
/// \errors py::type_error for another name.
[[nodiscard]] std::optional<double> timeout_of(const std::optional<double>& timeout,
                                               const py::kwargs& old_names);

/// Between Python and the library for the time of one call.
///
/// Python runs its handlers of signals between bytecodes of the main thread, of which there are
/// none while the library works. So a call from the main thread has a stop that SIGINT requests,
/// and afterwards lets Python's handler raise KeyboardInterrupt. What `progress` raises ends the
/// call, too, and is raised again.
class Call {
 public:
  /// \errors ErrorKind::usage for a negative number of threads; what a handler of a signal raises
  ///         that came before.
  Call(Work work, const CallLimits& allowed, const py::object& progress);
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  [[nodiscard]] const Limits& limits() const { return limits_; }

  /// Throws what ended the call in place of its error, if anything did.
  void raise_reason();

  /// Throws what `progress` raised, if it did.
  void raise_from_progress();

 private:
  void report(double share);

  Limits limits_;
  py::object progress_;
  bool is_main_ = false;
  StopSource* source_ = nullptr;
  StopSource* outer_ = nullptr;  ///< of the call whose progress makes this one
  std::optional<StopSource> own_;
  std::optional<py::error_already_set> raised_;
};

/// Gives the lock of the interpreter back for as long as it lives.
class Unlocked {
 public:
  Unlocked() : state_(PyEval_SaveThread()) {}

  ~Unlocked() { PyEval_RestoreThread(state_); }

  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  PyThreadState* state_;
};

/// What `body(limits)` returns, without the lock of the interpreter; it must touch no object of
/// Python.
template <class Body>
auto run(Work work, const CallLimits& allowed, const py::object& progress, Body&& body) {
  Call call(work, allowed, progress);
  try {
    auto answer = [&] {
      const Unlocked unlocked;
      return std::forward<Body>(body)(call.limits());
    }();
    call.raise_from_progress();
    return answer;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      call.raise_reason();
    }
    throw;
  }
}

/// Notes which thread is the main one. Once, when the module is loaded.
void prepare_calls();

}  // namespace soms::python
