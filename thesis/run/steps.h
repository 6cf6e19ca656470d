/// \file
/// Progress of an experiment that takes a known number of steps.
#pragma once

#include "soms/base/parallel.h"

#include <cstddef>
#include <utility>

namespace soms::reproduce {

/// Counts steps, reports the share done and heeds a stop request.
class Steps {
 public:
  Steps(Parallel parallel, std::size_t count) : parallel_(std::move(parallel)), count_(count) {}

  /// Call after each step. \errors ErrorKind::cancelled.
  void done_one() {
    check_stop(parallel_);
    ++done_;
    if (parallel_.progress && done_ <= count_) {
      parallel_.progress(static_cast<double>(done_) / static_cast<double>(count_));
    }
  }

  /// For the work of a step: heeds a stop request, reports nothing, uses one thread.
  [[nodiscard]] Parallel quiet() const { return {1, parallel_.stop, {}}; }

 private:
  Parallel parallel_;
  std::size_t count_;
  std::size_t done_ = 0;
};

}  // namespace soms::reproduce
