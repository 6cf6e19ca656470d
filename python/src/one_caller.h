/// \file
/// Objects that one thread may use at a time.
#pragma once

#include "python/src/errors.h"

#include <atomic>
#include <string>

namespace soms::python {

/// Keeps other threads, and calls from `progress`, off an object for as long as it lives.
class OneCaller {
 public:
  /// `what` is the object's name in errors. \errors ErrorKind::usage where another call is running.
  OneCaller(std::atomic<bool>& is_busy, const char* what) : is_busy_(is_busy) {
    if (is_busy.exchange(true)) {
      throw usage(std::string(what) + ": another call is running",
                  std::string("use a ") + what + " from one thread at a time");
    }
  }

  ~OneCaller() { is_busy_ = false; }

  OneCaller(const OneCaller&) = delete;
  OneCaller& operator=(const OneCaller&) = delete;

 private:
  std::atomic<bool>& is_busy_;
};

}  // namespace soms::python
