/// \file
/// How the queries of a batch begin, several at a time. A small body goes down the tree of a large
/// one alone (single_box_descent.h) and mostly ends there, having waited for every node on its way:
/// so each takes one node, in turn.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/engine/pair_list.h"
#include "soms/query/detail/single_box_descent.h"
#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace soms::detail {

/// What is known of a query before its traversal. It is over unless there are seeds.
struct RootDescent {
  std::optional<PairFrame>* frame;
  SingleBox box;
  PairList stack;
  PairList seeds;
  Cost cost;
  std::uint32_t node = 0;
};

/// A group of queries about the same two trees.
class BatchedRootDescent {
 public:
  static constexpr std::size_t kMost = 16;
  static constexpr std::size_t kTraversals = 4;  ///< most queries that may traverse meanwhile

  BatchedRootDescent();
  BatchedRootDescent(const BatchedRootDescent&) = delete;
  BatchedRootDescent& operator=(const BatchedRootDescent&) = delete;
  ~BatchedRootDescent() = default;

  void clear() { count_ = 0; }

  [[nodiscard]] bool full() const { return count_ == kMost; }

  [[nodiscard]] std::size_t size() const { return count_; }

  [[nodiscard]] RootDescent& operator[](std::size_t i) { return descents_[i]; }

  /// The frame of descent `i`, which is traversal `k`'s from now on, until that takes another.
  [[nodiscard]] PairFrame& take(std::size_t i, std::size_t k) {
    std::swap(descents_[i].frame, taken_[k]);
    return **taken_[k];
  }

  /// Adds a query. \pre Not full.
  void add(const PoseFrames& frames, const Pose& pose);

  /// Finds the seeds of all: those of `OverlapTraversal::start`, at the same costs.
  void look(const WideTree& y);

 private:
  std::array<std::optional<PairFrame>, kMost + kTraversals> frames_;  ///< not copied: pointed to
  std::array<std::optional<PairFrame>*, kTraversals> taken_;
  std::array<RootDescent, kMost> descents_;
  std::array<RootDescent*, kMost> going_ = {};
  std::size_t count_ = 0;
};

}  // namespace soms::detail
