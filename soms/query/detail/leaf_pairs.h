/// \file
/// Decides pairs of blocks that a traversal found: which of their triangles overlap.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/self/neighbor_queue.h"
#include "soms/query/detail/self/self_frame.h"

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace soms::detail {

/// A triangle at the side's pose.
[[nodiscard]] Triangle moved(const PosedShape& side, TriangleId id);

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

  /// The pairs of a task that its boxes leave: bit k of byte i for lane i of x and lane k of y.
  /// \pre Not full.
  [[nodiscard]] std::uint64_t test(const Kernels& kernels, const BlockTask& task) {
    return kernels.test_boxes(task, slots_[slots_used_]);
  }

  /// Puts in pairs of the task that was tested last.
  void take(const BlockTask& task, std::uint64_t pairs);

  /// Puts in all that `test` leaves. \pre Not full.
  void add(const Kernels& kernels, const BlockTask& task) { take(task, test(kernels, task)); }

  /// The same for pairs whose boxes are near. \pre Not full.
  void add(const Kernels& kernels, const BlockTask& task, const NearFilter& filter);

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Judges the pairs from `begin`, a multiple of kJudged, to `end` in float.
  void judge(const Kernels& kernels, std::size_t begin, std::size_t end);

  /// Judges in double what floats left open of the pairs from `begin` to `end`.
  void judge_open(const Kernels& kernels, const PoseNumbers& pose, std::size_t begin,
                  std::size_t end);

  /// What floats said of the kJudged pairs from `begin` on.
  [[nodiscard]] const Verdicts& in_float(std::size_t begin) const {
    return in_float_[begin / kJudged];
  }

  /// What doubles said of those that floats left open.
  [[nodiscard]] const Verdicts& in_double(std::size_t begin) const {
    return in_double_[begin / kJudged];
  }

  /// Bounds the distances of pairs `begin` to `begin + kJudged`, or as many as there are.
  void gaps(const Kernels& kernels, std::size_t begin, float reach, PairGaps& gaps);

  /// The first triangle of the pair is y's.
  [[nodiscard]] bool flipped(std::size_t i) const { return first_[i] % kSlotFloats >= kToY; }

  /// Triangles of x and y.
  [[nodiscard]] TrianglePair ids(std::size_t i) const {
    const TriangleSlot& slot = slots_[pair_[i] >> 6];
    return {slot.id_x[pair_[i] >> 3 & 7], slot.id_y[pair_[i] & 7]};
  }

 private:
  /// Fills the lists up to a multiple of kJudged; returns how many pairs there are from `begin` on.
  std::size_t fill(std::size_t begin);

  /// From a triangle of x in a slot to that of y.
  static constexpr std::uint32_t kToY = sizeof(TriangleSlot::Corners) / sizeof(float);
  static constexpr std::size_t kSlots = 16;
  static constexpr std::size_t kRoom = 64 * kSlots + kJudged;

  std::array<TriangleSlot, kSlots> slots_;
  std::array<std::uint32_t, kRoom> first_;  // places in the slots: see Kernels::judge
  std::array<std::uint32_t, kRoom> second_;
  std::array<std::uint16_t, kRoom> pair_;  // slot, lane of x, lane of y
  std::array<std::uint16_t, kRoom> open_;  // places in the lists above
  std::array<Verdicts, kRoom / kJudged> in_float_;
  std::array<Verdicts, kRoom / kJudged> in_double_;
  std::size_t size_ = 0;
  std::size_t slots_used_ = 0;
};

/// In place of a NeighborQueue, where two bodies have no corners in common.
struct NoNeighbors {
  NoNeighbors(const PairFrame& /*frame*/, const Kernels& /*kernels*/) {}
};

/// The leaves of one query.
template <class Frame>
class LeafPairs {
 public:
  LeafPairs(const Frame& frame, LeafQueue& queue)
      : frame_(&frame), kernels_(&kernels()), queue_(&queue), neighbors_(frame, *kernels_) {}

  /// Decides pairs of blocks whose slabs have been tested; true when the traversal is to stop.
  /// Where all pairs are requested, some wait in the queue until there are more, or these are the
  /// `last`.
  [[nodiscard]] bool decide(std::span<const BlockTask> tasks, bool last, Collector& collector,
                            Cost& cost);

 private:
  /// Puts the pairs of a task into the queue; true when the traversal is to stop.
  [[nodiscard]] bool take(const BlockTask& task, Collector& collector, Cost& cost);

  /// Empties the queue.
  [[nodiscard]] bool decide_queue(Collector& collector, Cost& cost);

  /// Adds what floats are sure of in the kJudged pairs from `begin` on.
  [[nodiscard]] bool take_sure(std::size_t begin, Collector& collector, Cost& cost) const;

  /// Adds what else overlaps of them.
  [[nodiscard]] bool take_open(std::size_t begin, Collector& collector, Cost& cost) const;

  /// Decides exactly what floats and doubles left open.
  [[nodiscard]] bool overlap(const TrianglePair& ids, Cost& cost) const;

  const Frame* frame_;
  const Kernels* kernels_;
  LeafQueue* queue_;
  std::conditional_t<Frame::kSelf, NeighborQueue, NoNeighbors> neighbors_;
};

extern template class LeafPairs<PairFrame>;
extern template class LeafPairs<SelfFrame>;

}  // namespace soms::detail
