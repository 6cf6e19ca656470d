/// \file
/// Where a traversal puts the pairs it finds, and what tells it to stop.
#pragma once

#include "soms/base/parallel.h"
#include "soms/query/overlap.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace soms::detail {

/// Ends long work: by request with an error, by deadline or another's hit with a verdict. Looks at
/// the clock once in a while only.
class Watch {
 public:
  Watch(const OverlapOptions& options, const Parallel& parallel,
        const std::atomic<bool>* done = nullptr)
      : deadline_(options.deadline), parallel_(&parallel), done_(done) {
    late_ = deadline_ && std::chrono::steady_clock::now() >= *deadline_;
  }

  /// Counts work; true when it is time to stop.
  [[nodiscard]] bool spend(std::uint64_t work) {
    spent_ += work;
    if (spent_ >= kInterval) {
      look();
    }
    return stopped();
  }

  /// The deadline passed.
  [[nodiscard]] bool late() const { return late_; }

  [[nodiscard]] bool stopped() const { return late_ || over_; }

 private:
  static constexpr std::uint64_t kInterval = 4096;  // about 100 us of work

  void look();

  std::optional<std::chrono::steady_clock::time_point> deadline_;
  const Parallel* parallel_;
  const std::atomic<bool>* done_;
  std::uint64_t spent_ = 0;
  bool late_ = false;
  bool over_ = false;
};

/// Takes pairs in the order of a traversal and keeps what the mode asks for.
class Collector {
 public:
  Collector(OverlapMode mode, std::uint64_t limit, std::vector<TrianglePair>& pairs)
      : mode_(mode), limit_(limit), pairs_(&pairs), begin_(pairs.size()) {}

  /// False for pairs whose decision can't matter any more.
  [[nodiscard]] bool wants(const TrianglePair& pair) const {
    return mode_ != OverlapMode::first || !any_ || pair < least_;
  }

  /// Adds a pair; true when the traversal is to stop.
  [[nodiscard]] bool add(const TrianglePair& pair) {
    if (mode_ != OverlapMode::all || pairs_->size() - begin_ >= limit_) {
      return add_to_few(pair);
    }
    any_ = true;
    pairs_->push_back(pair);
    return false;
  }

  [[nodiscard]] bool any() const { return any_; }

  /// The first pair found ends the traversal.
  [[nodiscard]] bool one() const { return mode_ == OverlapMode::any; }

  /// More pairs exist than the limit lets through.
  [[nodiscard]] bool full() const { return full_; }

  /// Brings what was added since construction into its final order.
  void finish();

 private:
  [[nodiscard]] bool add_to_few(const TrianglePair& pair);

  OverlapMode mode_;
  std::uint64_t limit_;
  std::vector<TrianglePair>* pairs_;
  std::size_t begin_;
  TrianglePair least_ = {};
  bool any_ = false;
  bool full_ = false;
};

}  // namespace soms::detail
