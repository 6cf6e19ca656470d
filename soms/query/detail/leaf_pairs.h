/// \file
/// Decides pairs of blocks that a traversal found: which of their triangles overlap.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/tree/shape.h"

#include <array>
#include <cstdint>
#include <span>

namespace soms::detail {

/// A shape at a pose, as one side of a traversal.
struct TraversalSide {
  const Shape* shape;
  const Pose* pose;
};

/// Pairs of triangles that wait to be judged together, so that no lane idles: those of few pairs of
/// blocks, each with a slot.
class LeafQueue {
 public:
  LeafQueue() = default;
  LeafQueue(const LeafQueue&) = delete;
  LeafQueue& operator=(const LeafQueue&) = delete;
  ~LeafQueue() = default;

  [[nodiscard]] bool empty() const { return size_ == 0; }

  [[nodiscard]] bool full() const { return slots_used_ == kSlots; }

  void clear() {
    size_ = 0;
    slots_used_ = 0;
  }

  /// Puts in the pairs of a task that its boxes leave.
  /// \pre Not full.
  void add(const Kernels& kernels, const BlockTask& task);

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Judges pairs `begin` to `begin + kJudged`, or as many as there are.
  [[nodiscard]] Verdicts judge(const Kernels& kernels, std::size_t begin);

  /// Triangles of x and y.
  [[nodiscard]] TrianglePair ids(std::size_t i) const {
    const TriangleSlot& slot = slots_[pair_[i] >> 6];
    return {slot.id_x[pair_[i] >> 3 & 7], slot.id_y[pair_[i] & 7]};
  }

 private:
  static constexpr std::size_t kSlots = 16;
  static constexpr std::size_t kRoom = 64 * kSlots + kJudged;

  std::array<TriangleSlot, kSlots> slots_;
  std::array<std::uint32_t, kRoom> first_;  // places in the slots: see Kernels::judge
  std::array<std::uint32_t, kRoom> second_;
  std::array<std::uint16_t, kRoom> pair_;  // slot, lane of x, lane of y
  std::size_t size_ = 0;
  std::size_t slots_used_ = 0;
};

/// The leaves of one query. Sides x and y are the caller's a and b, or b and a when `swapped`.
class LeafPairs {
 public:
  LeafPairs(const TraversalSide& x, const TraversalSide& y, bool swapped, LeafQueue& queue)
      : x_(x), y_(y), swapped_(swapped), kernels_(&kernels()), queue_(&queue) {}

  /// Decides pairs of blocks whose slabs have been tested; true when the traversal is to stop.
  /// Where all pairs are requested, some wait in the queue until there are more, or these are the
  /// `last`.
  [[nodiscard]] bool decide(std::span<const BlockTask> tasks, bool last, Collector& collector,
                            Cost& cost);

 private:
  /// Empties the queue.
  [[nodiscard]] bool decide_queue(Collector& collector, Cost& cost);

  /// Decides exactly what floats left open.
  [[nodiscard]] bool overlap(const TrianglePair& ids, Cost& cost) const;

  /// The caller's order.
  [[nodiscard]] TrianglePair ordered(const TrianglePair& ids) const {
    return swapped_ ? TrianglePair{ids.second, ids.first} : ids;
  }

  TraversalSide x_;
  TraversalSide y_;
  bool swapped_;
  const Kernels* kernels_;
  LeafQueue* queue_;
};

}  // namespace soms::detail
