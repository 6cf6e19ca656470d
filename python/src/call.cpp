#include "python/src/call.h"

#include "soms/base/threads.h"

#include "python/src/function.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

namespace soms::python {

namespace {

unsigned long main_thread = 0;

/// The stop of the call that the main thread is in. What it points to is never given back, as a
/// handler may look at it at any time.
std::atomic<StopSource*> running = nullptr;

/// The stop that the main thread's calls use, until one was requested.
StopSource* unused = nullptr;

/// What SIGINT did before, and still does. Never given back, likewise.
std::atomic<const struct sigaction*> handler_before = nullptr;

/// All that were ever in the two above: kept, so that what holds them finds them, and so that a
/// search for leaks does not take them for some.
struct Kept {
  std::vector<std::unique_ptr<StopSource>> stops;
  std::vector<std::unique_ptr<const struct sigaction>> handlers;
};

Kept& kept() {
  static Kept* const all = new Kept;
  return *all;
}

StopSource* new_stop() {
  return kept().stops.emplace_back(std::make_unique<StopSource>()).get();
}

/// Python's own handler, as the object that signal.signal was given, and what gets it.
PyObject* handler_object = nullptr;
PyObject* getsignal = nullptr;
PyObject* interrupt_number = nullptr;

/// The library only polls its stops and registers no callbacks, so to request one is an exchange of
/// an atomic number, which a handler may do.
void stop_running(int number, siginfo_t* info, void* context) {
  const int kept = errno;
  if (StopSource* const source = running.load()) {
    source->request_stop();
  }
  if (const struct sigaction* const before = handler_before.load()) {
    if ((before->sa_flags & SA_SIGINFO) != 0) {
      before->sa_sigaction(number, info, context);
    } else {
      before->sa_handler(number);
    }
  }
  errno = kept;
}

/// Puts `stop_running` before the handler of SIGINT that is there, if one is.
void follow_interrupts() {
  struct sigaction now = {};
  if (sigaction(SIGINT, nullptr, &now) != 0) {
    return;
  }
  const bool has_info = (now.sa_flags & SA_SIGINFO) != 0;
  if ((has_info && now.sa_sigaction == &stop_running) ||
      (!has_info && (now.sa_handler == SIG_DFL || now.sa_handler == SIG_IGN))) {
    return;
  }
  handler_before =
      kept().handlers.emplace_back(std::make_unique<const struct sigaction>(now)).get();
  struct sigaction ours = now;
  ours.sa_flags |= SA_SIGINFO;
  ours.sa_sigaction = &stop_running;
  sigaction(SIGINT, &ours, nullptr);
}

/// The same where it may be needed. A program that sets a handler again takes ours away, which
/// costs calls to the system to see: single queries look at Python's object alone, which tells, but
/// where the same one is set again.
void keep_following(Work work) {
  const py::object now =
      py::reinterpret_steal<py::object>(PyObject_CallOneArg(getsignal, interrupt_number));
  if (!now) {
    throw py::error_already_set();
  }
  if (work == Work::many || now.ptr() != handler_object) {
    Py_XDECREF(handler_object);
    handler_object = py::object(now).release().ptr();
    follow_interrupts();
  }
}

}  // namespace

void prepare_calls() {
  main_thread =
      py::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>();
  getsignal = py::object(py::module_::import("_signal").attr("getsignal")).release().ptr();
  interrupt_number = py::int_(SIGINT).release().ptr();
  unused = new_stop();
}

Call::Call(Work work, const CallLimits& allowed, const py::object& progress)
    : is_main_(PyThread_get_thread_ident() == main_thread) {
  if (allowed.threads < 0 || allowed.threads > kMostThreads) {
    throw usage("threads: " + std::to_string(allowed.threads),
                "give 0 for all processors, or a number up to " + std::to_string(kMostThreads));
  }
  limits_.threads = allowed.threads;
  limits_.deadline = allowed.deadline;
  if (is_main_) {
    if (PyErr_CheckSignals() != 0) {
      throw py::error_already_set();
    }
    keep_following(work);
    source_ = unused;
    outer_ = running.exchange(source_);
  } else if (!progress.is_none()) {
    source_ = &own_.emplace();
  }
  if (source_ != nullptr) {
    limits_.stop = source_->get_token();
  }
  if (!progress.is_none()) {
    progress_ = progress;
    limits_.progress = [this](double share) { report(share); };
  }
}

Call::~Call() {
  if (!is_main_) {
    return;
  }
  running = outer_;
  if (outer_ == nullptr && source_->stop_requested()) {
    unused = new_stop();  // the old one stays: a handler may hold it
  }
}

void Call::report(double share) {
  const py::gil_scoped_acquire locked;
  if (raised_) {
    return;
  }
  try {
    progress_(share);
  } catch (py::error_already_set& error) {
    raised_.emplace(error);
    source_->request_stop();
  }
}

void Call::raise_from_progress() {
  if (raised_) {
    throw py::error_already_set(*raised_);
  }
}

void Call::raise_reason() {
  raise_from_progress();
  if (is_main_ && PyErr_CheckSignals() != 0) {
    throw py::error_already_set();
  }
}

std::optional<double> timeout_of(const std::optional<double>& timeout,
                                 const py::kwargs& old_names) {
  std::optional<double> given = timeout;
  for (const auto& [name, value] : old_names) {
    if (given || name.cast<std::string>() != "seconds") {
      throw py::type_error("no argument is named " + py::repr(name).cast<std::string>());
    }
    warn_of_old_name("method", "seconds", "timeout");
    given = argument<std::optional<double>>("method", "timeout", value.ptr());
  }
  return given;
}

CallLimits::CallLimits(int threads_allowed, const std::optional<double>& timeout)
    : threads(threads_allowed) {
  if (!timeout) {
    return;
  }
  if (!(*timeout >= 0)) {
    throw usage("timeout: " + std::to_string(*timeout), "give a number from 0 on, or None");
  }
  constexpr double kLongest = 1e9;  // 30 years, which a clock can hold
  deadline = std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(std::min(*timeout, kLongest)));
}

}  // namespace soms::python
