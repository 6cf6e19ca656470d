#include "soms/query/detail/leaf_pairs.h"

#include "soms/geometry/triangle_overlap.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

namespace {

/// Leaves of a block's lanes those of triangles up to `id`.
void keep_up_to(TriangleId id, const TriangleBlock& block, std::uint32_t& lanes) {
  for (std::size_t k = 0; k < TriangleBlock::kWidth; ++k) {
    lanes &= ~((block.id[k] > id ? 1U : 0U) << k);
  }
}

/// A triangle of a side at its pose; of one body, in its own coordinates.
Triangle corners(const PairFrame& /*frame*/, const PosedShape& side, TriangleId id) {
  return moved(side, id);
}

Triangle corners(const SelfFrame& frame, const PosedShape& /*side*/, TriangleId id) {
  return frame.mesh().triangle(id);
}

}  // namespace

Triangle moved(const PosedShape& side, TriangleId id) {
  const Triangle t = side.shape->mesh().triangle(id);
  return {side.pose->apply(t.a), side.pose->apply(t.b), side.pose->apply(t.c)};
}

void LeafQueue::add(const Kernels& kernels, const BlockTask& task, const NearFilter& filter) {
  take(task, kernels.near_boxes(task, filter, slots_[slots_used_]));
}

void LeafQueue::take(const BlockTask& task, std::uint64_t pairs) {
  if (pairs == 0) {
    return;
  }
  const auto begin = static_cast<std::uint32_t>(slots_used_ * kSlotFloats);
  const auto number = static_cast<std::uint32_t>(slots_used_ << 6);
  // The smaller triangle comes first: floats decide more pairs so.
  const bool swap = task.x->l1_radius * task.pose->ratio > task.y->l1_radius;
  std::uint32_t* const x = swap ? second_.data() : first_.data();
  std::uint32_t* const y = swap ? first_.data() : second_.data();
  for (; pairs != 0; pairs &= pairs - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(pairs));
    x[size_] = begin + (bit >> 3);
    y[size_] = begin + kToY + (bit & 7);
    pair_[size_++] = static_cast<std::uint16_t>(number | bit);
  }
  ++slots_used_;
}

std::size_t LeafQueue::fill(std::size_t begin) {
  const std::size_t count = std::min(kJudged, size_ - begin);
  std::fill(first_.begin() + size_, first_.begin() + size_ + (kJudged - count), first_[begin]);
  std::fill(second_.begin() + size_, second_.begin() + size_ + (kJudged - count), second_[begin]);
  return count;
}

void LeafQueue::judge(const Kernels& kernels, std::size_t begin, std::size_t end) {
  for (; begin < end; begin += kJudged) {
    const std::size_t count = fill(begin);
    in_float_[begin / kJudged] =
        kernels.judge(slots_.data(), first_.data() + begin, second_.data() + begin, count);
  }
}

void LeafQueue::judge_open(const Kernels& kernels, const PoseNumbers& pose, std::size_t begin,
                           std::size_t end) {
  std::size_t count = 0;
  for (std::size_t set = begin; set < end; set += kJudged) {
    in_double_[set / kJudged] = {0, 0};
    for (std::uint32_t open = in_float(set).open; open != 0; open &= open - 1) {
      const std::size_t at = set + static_cast<std::size_t>(std::countr_zero(open));
      open_[count++] = static_cast<std::uint16_t>(at);
    }
  }
  for (std::size_t first = 0; first < count; first += kJudged) {
    const std::size_t some = std::min(kJudged, count - first);
    std::array<std::uint16_t, kJudged> pairs;
    for (std::size_t k = 0; k < some; ++k) {
      pairs[k] = pair_[open_[first + k]];
    }
    const Verdicts verdicts = kernels.judge_in_double(slots_.data(), pose, pairs.data(), some);
    for (std::size_t k = 0; k < some; ++k) {
      const std::size_t at = open_[first + k];
      Verdicts& of_set = in_double_[at / kJudged];
      of_set.hit |= (verdicts.hit >> k & 1U) << at % kJudged;
      of_set.open |= (verdicts.open >> k & 1U) << at % kJudged;
    }
  }
}

void LeafQueue::gaps(const Kernels& kernels, std::size_t begin, float reach, PairGaps& gaps) {
  const std::size_t count = fill(begin);
  kernels.near_pairs(slots_.data(), first_.data() + begin, second_.data() + begin, count, reach,
                     gaps);
}

template <class Frame>
bool LeafPairs<Frame>::take(const BlockTask& task, Collector& collector, Cost& cost) {
  std::uint64_t pairs = queue_->test(*kernels_, task);
  if constexpr (Frame::kSelf) {
    if (neighbors_.take(task, pairs, collector, cost)) {
      return true;
    }
  }
  queue_->take(task, pairs);
  return false;
}

template <class Frame>
bool LeafPairs<Frame>::decide(std::span<const BlockTask> tasks, bool last, Collector& collector,
                              Cost& cost) {
  for (const BlockTask& task : tasks) {
    if (task.lanes_x == 0 || task.lanes_y == 0) {
      continue;
    }
    cost.node_tests += task.x->count;
    if (queue_->full() && decide_queue(collector, cost)) {
      return true;
    }
    const TrianglePair* const least = Frame::kSelf ? nullptr : collector.least();
    if (least == nullptr) {
      if (take(task, collector, cost)) {
        return true;
      }
      continue;
    }
    BlockTask less = task;
    frame_->swapped() ? keep_up_to(least->a, *task.y, less.lanes_y)
                      : keep_up_to(least->a, *task.x, less.lanes_x);
    if (less.lanes_x != 0 && less.lanes_y != 0 && take(less, collector, cost)) {
      return true;
    }
  }
  if (!last && !collector.steers()) {
    return false;
  }
  if constexpr (Frame::kSelf) {
    if (neighbors_.decide(collector, cost)) {
      return true;
    }
  }
  return decide_queue(collector, cost);
}

template <class Frame>
bool LeafPairs<Frame>::decide_queue(Collector& collector, Cost& cost) {
  // Where one pair may be enough, a few are decided at a time.
  const bool steers = collector.steers();
  const std::size_t step = steers ? kJudged : queue_->size();
  for (std::size_t begin = 0; begin < queue_->size(); begin += step) {
    const std::size_t end = std::min(begin + step, queue_->size());
    queue_->judge(*kernels_, begin, end);
    if (steers && take_sure(begin, collector, cost)) {
      return true;
    }
    queue_->judge_open(*kernels_, frame_->relative().numbers(), begin, end);
    for (std::size_t set = begin; set < end; set += kJudged) {
      if ((!steers && take_sure(set, collector, cost)) || take_open(set, collector, cost)) {
        return true;
      }
    }
  }
  queue_->clear();
  return false;
}

template <class Frame>
bool LeafPairs<Frame>::take_sure(std::size_t begin, Collector& collector, Cost& cost) const {
  for (std::uint32_t hit = queue_->in_float(begin).hit; hit != 0; hit &= hit - 1) {
    ++cost.triangle_tests;
    const auto lane = static_cast<std::size_t>(std::countr_zero(hit));
    const auto [x, y] = queue_->ids(begin + lane);
    if (collector.add(frame_->in_callers_order(x, y))) {
      return true;
    }
  }
  return false;
}

template <class Frame>
bool LeafPairs<Frame>::take_open(std::size_t begin, Collector& collector, Cost& cost) const {
  const Verdicts& in_double = queue_->in_double(begin);
  for (std::uint32_t left = queue_->in_float(begin).open; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const TrianglePair ids = queue_->ids(begin + lane);
    const TrianglePair pair = frame_->in_callers_order(ids.a, ids.b);
    if (!collector.wants(pair)) {
      continue;
    }
    ++cost.triangle_tests;
    const bool open = (in_double.open >> lane & 1U) != 0;
    const bool hit = open ? overlap(ids, cost) : (in_double.hit >> lane & 1U) != 0;
    if (hit && collector.add(pair)) {
      return true;
    }
  }
  return false;
}

template <class Frame>
bool LeafPairs<Frame>::overlap(const TrianglePair& ids, Cost& cost) const {
  const Triangle s = corners(*frame_, frame_->x(), ids.a);
  const Triangle t = corners(*frame_, frame_->y(), ids.b);
  return overlaps(bounds(s), bounds(t)) && triangles_overlap(s, t, &cost.exact_tests);
}

template class LeafPairs<PairFrame>;
template class LeafPairs<SelfFrame>;

}  // namespace soms::detail
