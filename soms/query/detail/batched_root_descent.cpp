#include "soms/query/detail/batched_root_descent.h"

#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/engine/node_id.h"

#include <span>

namespace soms::detail {

namespace {

/// Starts to load what the traversal of a query will look at first.
void fetch_seeds(const PairList& seeds, const WideTree& y) {
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::uint32_t node_id = seeds.at(i).y;
    const WideNode& node = y.nodes()[index_of(node_id)];
    if (is_lane(node_id)) {
      fetch(y.blocks()[begin_of(node.child[lane_of(node_id)])]);
    } else {
      fetch(node);
    }
  }
}

}  // namespace

void BatchedRootDescent::add(const Pose& pose) {
  poses_[count_] = &pose;
  RootDescent& descent = descents_[count_++];
  descent.stack.clear();
  descent.seeds.clear();
  descent.cost = {};
  descent.cost.node_tests = 1;
  descent.node = 0;
}

std::size_t BatchedRootDescent::begin(const WideTree& y) {
  const bool has_grid = !y.min_max_grid().empty();
  std::size_t going = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if ((relative_.apart >> i & 1U) != 0) {
      continue;
    }
    RootDescent& descent = descents_[i];
    descent.box.take(relative_, i, has_grid);
    if (descent.box.pays(y.nodes()[0])) {
      going_[going++] = &descent;
    } else {
      descent.seeds.push({kRootId, kRootId});
    }
  }
  if (has_grid) {
    // Without a branch on what was found, so that the next look need not wait for this one.
    std::array<bool, kMost> clear = {};
    for (std::size_t i = 0; i < going; ++i) {
      clear[i] = going_[i]->box.clear_of(y);
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < going; ++i) {
      going_[left] = going_[i];
      left += clear[i] ? 0U : 1U;
    }
    going = left;
  }
  std::size_t begun = 0;
  for (std::size_t i = 0; i < going; ++i) {
    RootDescent& descent = *going_[i];
    going_[begun] = &descent;
    begun += descent.box.begin(y, descent.node, descent.stack) ? 1U : 0U;
  }
  return begun;
}

void BatchedRootDescent::look(const PoseFrames& frames) {
  const WideTree& y = frames.reference();
  const WideNode* const nodes = y.nodes().data();
  if (count_ != 0) {
    frames.find(std::span(poses_).first(count_), relative_);
  }
  std::size_t going = begin(y);
  while (going > 0) {
    for (std::size_t i = 0; i < going;) {
      RootDescent& descent = *going_[i];
      if (descent.box.step(nodes, descent.node, descent.stack, descent.seeds, descent.cost)) {
        ++i;
      } else {
        fetch_seeds(descent.seeds, y);
        going_[i] = going_[--going];
      }
    }
  }
}

}  // namespace soms::detail
