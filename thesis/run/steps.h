/// \file
/// Progress of an experiment that takes a known number of steps.
#pragma once

#include "soms/base/limits.h"

#include <cstddef>
#include <utility>

namespace soms::reproduce {

/// Counts steps, reports the share done and heeds a stop request.
class Steps {
 public:
  Steps(Limits limits, std::size_t count) : limits_(std::move(limits)), count_(count) {}

  /// Call after each step. \errors ErrorKind::cancelled.
  void done_one() {
    check_stop(limits_);
    ++done_;
    if (limits_.progress && done_ <= count_) {
      limits_.progress(static_cast<double>(done_) / static_cast<double>(count_));
    }
  }

  /// For the work of a step: heeds a stop request, reports nothing, uses one thread.
  [[nodiscard]] Limits quiet() const { return limits_.without_deadline().alone(); }

 private:
  Limits limits_;
  std::size_t count_;
  std::size_t done_ = 0;
};

}  // namespace soms::reproduce
