#include "soms/query/detail/near/point_traversal.h"

#include "soms/query/detail/kernels/instruction_set.h"

#include <algorithm>
#include <array>
#include <utility>

namespace soms::detail {

template <class Source>
PointTraversal<Source>::PointTraversal(const PointFrame& frame, PointPose& pose, PointGoal& goal,
                                       PointMemory& memory)
    : pose_(pose), goal_(goal), memory_(memory), source_(*frame.body().shape), kernels_(kernels()) {
  memory_.nodes.clear();
  memory_.candidates.clear();
  pose_.set_limit(goal_.upper());
}

template <class Source>
void PointTraversal<Source>::run(Limit& limit) {
  std::vector<KeyedNode>& nodes = memory_.nodes;
  nodes.push_back({-std::numeric_limits<float>::infinity(), 0});
  while (!nodes.empty()) {
    if (limit.spend(1 + std::exchange(work_, 0))) {
      return;
    }
    const KeyedNode next = nodes.back();
    nodes.pop_back();
    if (next.key > pose_.limit()) {
      continue;
    }
    if ((next.word & WideNode::kLeafBit) != 0) {
      if (!look_at_leaf(next.word, limit)) {
        nodes.push_back(next);  // what is left of it is no nearer than its key
        return;
      }
    } else {
      open(source_.node(next.word));
    }
  }
  settle();
  complete_ = true;
}

template <class Source>
double PointTraversal<Source>::at_least() const {
  float least = std::numeric_limits<float>::infinity();
  for (const KeyedNode& node : memory_.nodes) {
    least = std::min(least, node.key);
  }
  for (const PointCandidate& candidate : memory_.candidates) {
    least = std::min(least, candidate.key);
  }
  return std::min(pose_.distance_of(least), goal_.upper());
}

template <class Source>
void PointTraversal<Source>::open(const WideNode& node) {
  PointNodeKeys keys;
  if (pose_.far()) {
    pose_.far_keys(node, keys);
  } else {
    kernels_.bound_boxes(pose_.numbers(), node, keys);
  }
  cost_.node_tests += node.count;
  std::array<KeyedNode, WideNode::kWidth> children;
  std::size_t count = 0;
  for (std::size_t k = 0; k < node.count; ++k) {
    const KeyedNode child = {keys.key[k], node.child[k]};
    if (child.key > pose_.limit()) {
      continue;
    }
    if ((child.word & WideNode::kLeafBit) != 0) {
      source_.fetch_block(child.word);
    } else {
      source_.fetch_node(child.word);
    }
    // The nearest comes last.
    std::size_t at = count++;
    for (; at > 0 && children[at - 1].key < child.key; --at) {
      children[at] = children[at - 1];
    }
    children[at] = child;
  }
  for (std::size_t k = 0; k < count; ++k) {
    memory_.nodes.push_back(children[k]);
  }
}

template <class Source>
bool PointTraversal<Source>::look_at_leaf(std::uint32_t token, Limit& limit) {
  for (;; token = source_.next(token)) {
    const TriangleBlock& block = source_.block(token);
    const bool last = block.following == 0;
    look_at(block);
    if (last) {
      return true;
    }
    if (limit.spend(std::exchange(work_, 0))) {
      return false;
    }
  }
}

template <class Source>
void PointTraversal<Source>::look_at(const TriangleBlock& block) {
  PointBlockKeys keys;
  if (pose_.far()) {
    pose_.far_keys(block, keys);
  } else {
    kernels_.bound_triangles(pose_.numbers(), block, keys);
  }
  cost_.triangle_tests += block.count;
  work_ += 2;
  if (goal_.eager()) {
    offer_all(block, keys);
  } else {
    offer_nearest(block, keys);
  }
}

template <class Source>
void PointTraversal<Source>::offer_nearest(const TriangleBlock& block, const PointBlockKeys& keys) {
  const std::size_t count = block.count;
  std::size_t best = count;
  for (std::size_t k = 0; k < count; ++k) {
    if (!(keys.key[k] > pose_.limit()) && keys.estimate[k] < best_estimate_) {
      best_estimate_ = keys.estimate[k];
      best = k;
    }
  }
  if (best != count) {
    offer(block.id[best]);
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (k == best || keys.key[k] > pose_.limit()) {
      continue;
    }
    memory_.candidates.push_back({keys.key[k], block.id[k]});
    if (memory_.candidates.size() == kCandidates) {
      settle();
    }
  }
}

template <class Source>
void PointTraversal<Source>::offer_all(const TriangleBlock& block, const PointBlockKeys& keys) {
  std::array<std::size_t, TriangleBlock::kWidth> order;  // the nearest first
  std::size_t count = 0;
  for (std::size_t k = 0; k < block.count; ++k) {
    if (keys.key[k] > pose_.limit()) {
      continue;
    }
    std::size_t at = count++;
    for (; at > 0 && keys.estimate[k] < keys.estimate[order[at - 1]]; --at) {
      order[at] = order[at - 1];
    }
    order[at] = k;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!(keys.key[order[i]] > pose_.limit())) {
      offer(block.id[order[i]]);
    }
  }
}

template <class Source>
void PointTraversal<Source>::offer(TriangleId id) {
  goal_.offer(id, cost_);
  work_ += kOfferWork;
  pose_.set_limit(goal_.upper());
}

template <class Source>
void PointTraversal<Source>::settle() {
  std::vector<PointCandidate>& candidates = memory_.candidates;
  std::sort(candidates.begin(), candidates.end());
  for (const PointCandidate& candidate : candidates) {
    if (candidate.key > pose_.limit()) {
      break;
    }
    offer(candidate.id);
  }
  candidates.clear();
}

template class PointTraversal<WideSource>;
template class PointTraversal<CompactSource>;

}  // namespace soms::detail
