/// \file
/// How the queries of a batch begin, several at a time. A small body goes down the tree of a large
/// one alone (single_box_descent.h) and mostly ends there, having waited for every node on its way:
/// so each takes one node, in turn.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/pair_list.h"
#include "soms/query/detail/relative_pose.h"
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
  std::optional<RelativePose>* relative;
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

  /// The relative pose of descent `i`, which is traversal `k`'s from now on, until that takes
  /// another.
  [[nodiscard]] RelativePose& take(std::size_t i, std::size_t k) {
    std::swap(descents_[i].relative, taken_[k]);
    return **taken_[k];
  }

  /// Adds a query. \pre Not full.
  void add(const WideTree& x, const Pose& pose_x, const ReferenceFrame& y);

  /// Finds the seeds of all: those of `PairTraversal::start`, at the same costs.
  void look(const WideTree& y);

 private:
  std::array<std::optional<RelativePose>, kMost + kTraversals> poses_;  ///< not copied: pointed to
  std::array<std::optional<RelativePose>*, kTraversals> taken_;
  std::array<RootDescent, kMost> descents_;
  std::array<RootDescent*, kMost> going_ = {};
  std::size_t count_ = 0;
};

}  // namespace soms::detail
