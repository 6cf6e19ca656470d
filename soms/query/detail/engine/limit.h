/// \file
/// What ends a query before its answer is complete.
#pragma once

#include "soms/base/limits.h"

#include <atomic>
#include <cstdint>

namespace soms::detail {

/// Ends long work: by request with an error, by deadline or another's hit with a verdict. Looks at
/// the clock once in a while only.
class Limit {
 public:
  /// `done`, if any, ends the work once it is set: another part of the query has the answer.
  explicit Limit(const Limits& limits, const std::atomic<bool>* done = nullptr)
      : limits_(&limits), done_(done), late_(limits.late()) {}

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

  const Limits* limits_;
  const std::atomic<bool>* done_;
  std::uint64_t spent_ = 0;
  bool late_ = false;
  bool done_elsewhere_ = false;
};

}  // namespace soms::detail
