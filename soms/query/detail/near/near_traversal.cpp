#include "soms/query/detail/near/near_traversal.h"

#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/single_box_descent.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

namespace {

/// Both nodes are descended while neither is more than this much larger.
constexpr float kSimilarNear = 2;

/// A body goes down the other tree as a single box where that is so much larger than what is near.
constexpr float kWithinReach = 8;

std::uint32_t lanes_of(const WideNode& node, std::uint32_t node_id) {
  return is_lane(node_id) ? 1U << lane_of(node_id) : (1U << node.count) - 1;
}

/// A node that has the box of all lanes of another in each of its own.
void make_lone(const WideNode& node, WideNode& lone) {
  lone.row = node.row;
  lone.origin = node.origin;
  lone.l1_radius = node.l1_radius;
  lone.oriented = node.oriented;
  for (std::size_t i = 0; i < 3; ++i) {
    lone.center[i].fill(0);
    lone.half[i].fill(node.row[i][3]);
  }
}

}  // namespace

template <class Source>
NearTraversal<Source>::NearTraversal(const PairFrame& frame, NearPose& pose, NearGoal& goal,
                                     NearMemory& memory)
    : frame_(&frame),
      pose_(pose),
      goal_(goal),
      memory_(memory),
      x_(*frame.x().shape),
      y_(*frame.y().shape),
      large_leaf_(frame.relative(), x_, y_),
      kernels_(kernels()) {
  pose_.set_limit(goal_.upper());
  best_estimate_ = pose_.limit();
  memory_.pairs.clear();
  memory_.candidates.clear();
  memory_.leaves.clear();
}

template <class Source>
bool NearTraversal<Source>::run(Limit& limit, std::uint64_t steps) {
  for (; steps != 0; --steps) {
    if (!step(limit)) {
      return true;
    }
    if (!memory_.pairs.sorted() && pose_.limit() < std::numeric_limits<float>::infinity()) {
      sort();
    }
  }
  return false;
}

template <class Source>
void NearTraversal<Source>::sort() {
  KeyedPairs& pairs = memory_.pairs;
  pairs.sort(pose_.far() ? pairs.least_left() : 0, pose_.limit());
}

template <class Source>
void NearTraversal<Source>::start_part(const NearTraversal& whole,
                                       std::span<const KeyedPair> pairs) {
  filter_ = whole.filter_;
  turned_to_ = whole.turned_to_;
  best_estimate_ = whole.best_estimate_;
  for (const KeyedPair& pair : pairs) {
    memory_.pairs.push(pair);
  }
  sort();
}

template <class Source>
void NearTraversal<Source>::give(std::size_t count, std::vector<KeyedPair>& pairs) {
  KeyedPair pair;
  while (pairs.size() < count && memory_.pairs.pop(pose_.limit(), pair)) {
    pairs.push_back(pair);
  }
}

template <class Source>
void NearTraversal<Source>::finish() {
  // Either way nothing is left to be done.
  static_cast<void>(empty_queue() || settle());
  complete_ = true;
}

template <class Source>
bool NearTraversal<Source>::take(const NearTraversal& part) {
  cost_ += part.cost_;
  unfinished_ = std::min(unfinished_, part.unfinished_);
  for (const NearCandidate& candidate : part.memory_.candidates) {
    unfinished_ = std::min(unfinished_, candidate.key);
  }
  KeyedPair pair;
  while (part.memory_.pairs.pop(std::numeric_limits<float>::infinity(), pair)) {
    memory_.pairs.push(pair);
  }
  if (part.turned_to_ < turned_to_) {
    filter_ = part.filter_;
    turned_to_ = part.turned_to_;
  }
  best_estimate_ = std::min(best_estimate_, part.best_estimate_);
  complete_ = part.goal_.kept() && offer(*part.goal_.kept());
  return complete_;
}

template <class Source>
void NearTraversal<Source>::start() {
  constexpr float kNoBound = -std::numeric_limits<float>::infinity();
  if constexpr (Source::kInPlace) {
    SingleBox box;
    frame_->relative().single_box(box);
    box.slack = pose_.numbers().slack;
    const WideNode* const nodes = y_.nodes();
    if (!pose_.far() && box.pays(nodes[0]) && nodes[0].l1_radius > kWithinReach * box.slack) {
      const WideTree& y = frame_->y().layout();
      ++cost_.node_tests;
      box.find_place(y);
      if (!box.clear_of(y)) {
        box.descend(y, memory_.stack, memory_.seeds, cost_);
      }
      for (std::size_t i = 0; i < memory_.seeds.size(); ++i) {
        memory_.pairs.push({kNoBound, memory_.seeds.at(i)});
      }
      memory_.seeds.clear();
      return;
    }
  }
  memory_.pairs.push({kNoBound, {kRootId, kRootId}});
}

template <class Source>
double NearTraversal<Source>::at_least() const {
  float least = std::min(unfinished_, memory_.pairs.least_left());
  for (const NearCandidate& candidate : memory_.candidates) {
    least = std::min(least, candidate.key);
  }
  return std::min(pose_.distance_of(least), goal_.upper());
}

template <class Source>
void NearTraversal<Source>::open(const NodeRefPair& pair) {
  const WideNode& x = x_.node(index_of(pair.x));
  const WideNode& y = y_.node(index_of(pair.y));
  if (is_lane(pair.x | pair.y) && !pose_.far() &&
      pose_.limit() < std::numeric_limits<float>::infinity() &&
      !large_leaf_.meets(pair, x, y, pose_.limit(), cost_)) {
    return;
  }
  NodeTask& task = tasks_[task_count_];
  Opening& opening = openings_[task_count_++];
  task.pose = &pose_.numbers();
  task.x = &x;
  task.y = &y;
  opening.from = pair;
  opening.only_x = false;
  opening.only_y = false;
  if (!is_lane(pair.x | pair.y)) {
    const float size_x = x.l1_radius * pose_.numbers().ratio;
    opening.only_x = size_x > kSimilarNear * y.l1_radius;
    opening.only_y = y.l1_radius > kSimilarNear * size_x;
  }
  if (opening.only_x || opening.only_y) {
    const WideNode& descended = opening.only_x ? x : y;
    make_lone(opening.only_x ? y : x, opening.box);
    (opening.only_x ? task.y : task.x) = &opening.box;
    task.pairs = (1U << descended.count) - 1;
  } else {
    task.pairs = kLanePairs.bits[lanes_of(x, pair.x)][lanes_of(y, pair.y)];
  }
  cost_.node_tests += static_cast<unsigned>(std::popcount(task.pairs));
}

template <class Source>
void NearTraversal<Source>::push_children(std::size_t i) {
  const NodeTask& task = tasks_[i];
  const Opening& opening = openings_[i];
  const NodeRefPair& from = opening.from;
  const bool sorted = memory_.pairs.sorted();
  std::array<KeyedPair, 16> children;
  std::size_t count = 0;
  for (std::uint32_t left = keys_[i].near; left != 0; left &= left - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
    const std::uint32_t lane_x = bit % 4;
    const std::uint32_t lane_y = (lane_x + bit / 4) % 4;
    KeyedPair child = {keys_[i].key[bit], from};
    if (!opening.only_y) {
      child.nodes.x = child_id(*task.x, without_lane(from.x), lane_x);
    }
    if (!opening.only_x) {
      child.nodes.y = child_id(*task.y, without_lane(from.y), lane_y);
    }
    x_.fetch_node(index_of(child.nodes.x));
    y_.fetch_node(index_of(child.nodes.y));
    if (sorted) {
      memory_.pairs.push(child);
      continue;
    }
    // The nearest comes last.
    std::size_t at = count++;
    for (; at > 0 && children[at - 1].key < child.key; --at) {
      children[at] = children[at - 1];
    }
    children[at] = child;
  }
  for (std::size_t k = 0; k < count; ++k) {
    memory_.pairs.push(children[k]);
  }
}

template <class Source>
bool NearTraversal<Source>::step(Limit& limit) {
  const std::size_t most = memory_.pairs.sorted() ? kGroup : 1;
  std::array<KeyedPair, kGroup> leaves;
  std::size_t leaf_count = 0;
  task_count_ = 0;
  KeyedPair next;
  while (task_count_ + leaf_count < most && memory_.pairs.pop(pose_.limit(), next)) {
    if (is_lane(next.nodes.x) && is_lane(next.nodes.y)) {
      leaves[leaf_count++] = next;
    } else {
      open(next.nodes);
    }
  }
  if (task_count_ + leaf_count == 0) {
    finish();
    return false;
  }
  if (pose_.far()) {
    for (std::size_t i = 0; i < task_count_; ++i) {
      pose_.far_keys(tasks_[i], pose_.limit(), keys_[i]);
    }
  } else {
    kernels_.bound_nodes(tasks_.data(), task_count_, pose_.limit(), keys_.data());
  }
  for (std::size_t i = 0; i < task_count_; ++i) {
    push_children(i);
  }
  for (std::size_t i = 0; i < leaf_count; ++i) {
    complete_ = look_at_leaves(leaves[i].nodes, limit);
    if (complete_ || limit.late()) {
      // Triangles of the leaves before may still wait in the queue.
      for (std::size_t k = 0; k < leaf_count; ++k) {
        unfinished_ = std::min(unfinished_, leaves[k].key);
      }
      return false;
    }
  }
  complete_ = leaf_count != 0 && empty_queue();
  return !complete_ && !limit.spend(1 + 2 * task_count_);
}

template <class Source>
bool NearTraversal<Source>::look_at_leaves(const NodeRefPair& leaves, Limit& limit) {
  const std::uint32_t first_x = x_.node(index_of(leaves.x)).child[lane_of(leaves.x)];
  const std::uint32_t first_y = y_.node(index_of(leaves.y)).child[lane_of(leaves.y)];
  for (std::uint32_t token_x = first_x;; token_x = x_.next(token_x)) {
    const TriangleBlock& x = x_.block(token_x);
    std::uint64_t blocks = 0;
    for (std::uint32_t token_y = first_y;; token_y = y_.next(token_y)) {
      const TriangleBlock& y = y_.block(token_y);
      ++blocks;
      if (look_at_blocks(x, y)) {
        return true;
      }
      if (y.following == 0) {
        break;
      }
    }
    if (x.following == 0 || limit.spend(std::uint64_t{4} * blocks)) {
      return false;
    }
  }
}

template <class Source>
bool NearTraversal<Source>::look_at_blocks(const TriangleBlock& x, const TriangleBlock& y) {
  cost_.node_tests += x.count + y.count;
  if (pose_.far()) {
    return look_at_far(x, y);
  }
  BlockTask task = {};
  task.pose = &pose_.numbers();
  task.x = &x;
  task.y = &y;
  kernels_.test_slabs(&task, 1);
  if (task.lanes_x == 0 || task.lanes_y == 0) {
    return false;
  }
  if (memory_.leaves.full() && empty_queue()) {
    return true;
  }
  filter_.reach = pose_.limit();
  memory_.leaves.add(kernels_, task, filter_);
  return false;
}

template <class Source>
bool NearTraversal<Source>::empty_queue() {
  LeafQueue& queue = memory_.leaves;
  PairGaps gaps;
  for (std::size_t begin = 0; begin < queue.size(); begin += kJudged) {
    queue.gaps(kernels_, begin, pose_.limit(), gaps);
    if (look_at(gaps, begin, std::min(kJudged, queue.size() - begin))) {
      return true;
    }
  }
  queue.clear();
  return false;
}

template <class Source>
bool NearTraversal<Source>::look_at(const PairGaps& gaps, std::size_t begin, std::size_t count) {
  cost_.triangle_tests += count;
  turn_filter(gaps, begin, count);
  std::size_t best = count;
  for (std::uint32_t left = gaps.near; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    if (gaps.estimate[i] < best_estimate_) {
      best_estimate_ = gaps.estimate[i];
      best = i;
    }
  }
  if (best != count && offer(memory_.leaves.ids(begin + best))) {
    return true;
  }
  for (std::uint32_t left = gaps.near; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    if (i != best && keep({gaps.lower[i], memory_.leaves.ids(begin + i)})) {
      return true;
    }
  }
  return false;
}

template <class Source>
void NearTraversal<Source>::turn_filter(const PairGaps& gaps, std::size_t begin,
                                        std::size_t count) {
  const auto first = gaps.estimate.begin();
  const auto nearest = std::min_element(first, first + static_cast<std::ptrdiff_t>(count));
  if (!(*nearest < turned_to_)) {
    return;
  }
  turned_to_ = *nearest;
  const auto i = static_cast<std::size_t>(nearest - first);
  const float length = std::max(turned_to_, 0x1p-60F) * (1 + 0x1p-10F);
  const float factor = (memory_.leaves.flipped(begin + i) ? -1 : 1) / length;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    filter_.direction[axis] = gaps.line[axis][i] * factor;
  }
}

template <class Source>
bool NearTraversal<Source>::look_at_far(const TriangleBlock& x, const TriangleBlock& y) {
  NearPose::BlockKeys keys;
  pose_.far_keys(x, y, keys);
  TrianglePair best = {};
  bool better = false;
  for (std::size_t i = 0; i < x.count; ++i) {
    for (std::size_t k = 0; k < y.count; ++k) {
      if (keys[i][k] < best_estimate_) {
        best_estimate_ = keys[i][k];
        best = {x.id[i], y.id[k]};
        better = true;
      }
    }
  }
  if (better && offer(best)) {
    return true;
  }
  for (std::size_t i = 0; i < x.count; ++i) {
    for (std::size_t k = 0; k < y.count; ++k) {
      const TrianglePair ids = {x.id[i], y.id[k]};
      if (!(better && ids == best) && keep({keys[i][k], ids})) {
        return true;
      }
    }
  }
  return false;
}

template <class Source>
bool NearTraversal<Source>::offer(const TrianglePair& ids) {
  if (goal_.offer(ids, cost_)) {
    return true;
  }
  pose_.set_limit(goal_.upper());
  return false;
}

template <class Source>
bool NearTraversal<Source>::keep(const NearCandidate& candidate) {
  if (candidate.key > pose_.limit()) {
    return false;
  }
  if (!pose_.far() && !(candidate.key > 0)) {
    return offer(candidate.ids);
  }
  memory_.candidates.push_back(candidate);
  return memory_.candidates.size() == kCandidates && settle();
}

template <class Source>
bool NearTraversal<Source>::settle() {
  std::vector<NearCandidate>& candidates = memory_.candidates;
  std::sort(candidates.begin(), candidates.end());
  for (const NearCandidate& candidate : candidates) {
    if (candidate.key > pose_.limit()) {
      break;
    }
    if (offer(candidate.ids)) {
      return true;
    }
  }
  candidates.clear();
  return false;
}

template class NearTraversal<WideSource>;
template class NearTraversal<CompactSource>;

}  // namespace soms::detail
