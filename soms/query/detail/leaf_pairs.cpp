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

}  // namespace

Triangle moved(const PosedShape& side, TriangleId id) {
  const Triangle t = side.shape->mesh().triangle(id);
  return {side.pose->apply(t.a), side.pose->apply(t.b), side.pose->apply(t.c)};
}

void LeafQueue::add(const Kernels& kernels, const BlockTask& task) {
  take(task, kernels.test_boxes(task, slots_[slots_used_]));
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

Verdicts LeafQueue::judge(const Kernels& kernels, std::size_t begin) {
  const std::size_t count = fill(begin);
  return kernels.judge(slots_.data(), first_.data() + begin, second_.data() + begin, count);
}

void LeafQueue::gaps(const Kernels& kernels, std::size_t begin, float reach, PairGaps& gaps) {
  const std::size_t count = fill(begin);
  kernels.near_pairs(slots_.data(), first_.data() + begin, second_.data() + begin, count, reach,
                     gaps);
}

bool LeafPairs::decide(std::span<const BlockTask> tasks, bool last, Collector& collector,
                       Cost& cost) {
  for (const BlockTask& task : tasks) {
    if (task.lanes_x == 0 || task.lanes_y == 0) {
      continue;
    }
    cost.node_tests += task.x->count;
    if (queue_->full() && decide_queue(collector, cost)) {
      return true;
    }
    if (const TrianglePair* const least = collector.least()) {
      BlockTask less = task;
      frame_->swapped() ? keep_up_to(least->first, *task.y, less.lanes_y)
                        : keep_up_to(least->first, *task.x, less.lanes_x);
      if (less.lanes_x != 0 && less.lanes_y != 0) {
        queue_->add(*kernels_, less);
      }
    } else {
      queue_->add(*kernels_, task);
    }
  }
  return (last || collector.steers()) && decide_queue(collector, cost);
}

bool LeafPairs::decide_queue(Collector& collector, Cost& cost) {
  for (std::size_t begin = 0; begin < queue_->size(); begin += kJudged) {
    const Verdicts verdicts = queue_->judge(*kernels_, begin);
    for (std::uint32_t hit = verdicts.hit; hit != 0; hit &= hit - 1) {
      ++cost.triangle_tests;
      const auto lane = static_cast<std::size_t>(std::countr_zero(hit));
      const auto [x, y] = queue_->ids(begin + lane);
      if (collector.add(frame_->in_callers_order(x, y))) {
        return true;
      }
    }
    for (std::uint32_t open = verdicts.open; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(open));
      const TrianglePair ids = queue_->ids(begin + lane);
      const TrianglePair pair = frame_->in_callers_order(ids.first, ids.second);
      if (collector.wants(pair) && overlap(ids, cost) && collector.add(pair)) {
        return true;
      }
    }
  }
  queue_->clear();
  return false;
}

bool LeafPairs::overlap(const TrianglePair& ids, Cost& cost) const {
  const Triangle s = moved(frame_->x(), ids.first);
  const Triangle t = moved(frame_->y(), ids.second);
  if (!overlaps(bounds(s), bounds(t))) {
    return false;
  }
  ++cost.triangle_tests;
  return triangles_overlap(s, t, &cost.exact_tests);
}

}  // namespace soms::detail
