/// \file
/// How the queries of a batch begin, several at a time. A small body goes down the tree of a large
/// one alone (single_box_descent.h) and mostly ends there, having waited for every node on its way:
/// so each takes one node, in turn.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/engine/pair_list.h"
#include "soms/query/detail/single_box_descent.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace soms::detail {

/// What is known of a query before its traversal. It is over unless there are seeds.
struct RootDescent {
  SingleBox box;
  PairList stack;
  PairList seeds;
  Cost cost;
  std::uint32_t node = 0;
};

/// A group of queries about the same two trees.
class BatchedRootDescent {
 public:
  static constexpr std::size_t kMost = RelativePoses::kMost;
  static constexpr std::size_t kTraversals = 4;  ///< most queries that may traverse meanwhile

  BatchedRootDescent() = default;
  BatchedRootDescent(const BatchedRootDescent&) = delete;
  BatchedRootDescent& operator=(const BatchedRootDescent&) = delete;
  ~BatchedRootDescent() = default;

  void clear() { count_ = 0; }

  [[nodiscard]] bool full() const { return count_ == kMost; }

  [[nodiscard]] std::size_t size() const { return count_; }

  [[nodiscard]] RootDescent& operator[](std::size_t i) { return descents_[i]; }

  /// The frame of descent `i`, in place of that which traversal `k` had.
  [[nodiscard]] PairFrame& frame(const PoseFrames& frames, std::size_t i, std::size_t k) {
    frames.place(*poses_[i], relative_, i, frames_[k]);
    return *frames_[k];
  }

  /// Adds a query. \pre Not full.
  void add(const Pose& pose);

  /// Finds the seeds of all: those of `OverlapTraversal::start`, at the same costs.
  void look(const PoseFrames& frames);

 private:
  /// Descents that neither the bounds nor the height grid ends, where x goes down y alone.
  [[nodiscard]] std::size_t begin(const WideTree& y);

  std::array<const Pose*, kMost> poses_ = {};
  RelativePoses relative_;
  std::array<std::optional<PairFrame>, kTraversals> frames_;
  std::array<RootDescent, kMost> descents_;
  std::array<RootDescent*, kMost> going_ = {};
  std::size_t count_ = 0;
};

}  // namespace soms::detail
