/// \file
/// Where a traversal puts the pairs it finds.
#pragma once

#include "soms/query/overlap.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::detail {

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

  /// What is found decides what is looked at next.
  [[nodiscard]] bool steers() const { return mode_ != OverlapMode::all; }

  /// The least pair so far, where no other is wanted that is not less.
  [[nodiscard]] const TrianglePair* least() const {
    return mode_ == OverlapMode::first && any_ ? &least_ : nullptr;
  }

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
