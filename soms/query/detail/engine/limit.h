/// \file
/// What ends a query before its answer is complete.
#pragma once

#include "soms/base/parallel.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

namespace soms::detail {

/// Ends long work: by request with an error, by deadline or another's hit with a verdict. Looks at
/// the clock once in a while only.
class Limit {
 public:
  /// `done`, if any, ends the work once it is set: another part of the query has the answer.
  Limit(std::optional<std::chrono::steady_clock::time_point> deadline, const Parallel& parallel,
        const std::atomic<bool>* done = nullptr)
      : deadline_(deadline), parallel_(&parallel), done_(done) {
    late_ = deadline_ && std::chrono::steady_clock::now() >= *deadline_;
  }

  /// Counts work, in tests of about 25 ns; true when it is time to stop.
  /// \errors ErrorKind::cancelled.
  [[nodiscard]] bool spend(std::uint64_t work) {
    spent_ += work;
    if (spent_ >= kInterval) {
      look();
    }
    return late_ || done_elsewhere_;
  }

  /// The deadline passed.
  [[nodiscard]] bool late() const { return late_; }

 private:
  static constexpr std::uint64_t kInterval = 4096;  // about 100 us of work

  void look();

  std::optional<std::chrono::steady_clock::time_point> deadline_;
  const Parallel* parallel_;
  const std::atomic<bool>* done_;
  std::uint64_t spent_ = 0;
  bool late_ = false;
  bool done_elsewhere_ = false;
};

}  // namespace soms::detail
