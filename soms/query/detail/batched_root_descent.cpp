#include "soms/query/detail/batched_root_descent.h"

#include "soms/query/detail/fetch.h"
#include "soms/query/detail/kernels/kernels.h"

namespace soms::detail {

namespace {

/// Starts to load what the traversal of a query will look at first.
void fetch_seeds(const PairList& seeds, const WideTree& y) {
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::uint32_t node_id = seeds.at(i).y;
    const WideNode& node = y.nodes()[node_id >> 3];
    if ((node_id & NodeTask::kLane) != 0) {
      fetch(y.blocks()[node.child[node_id & 3] & (WideNode::kMost - 1)]);
    } else {
      fetch(node);
    }
  }
}

}  // namespace

BatchedRootDescent::BatchedRootDescent() {
  for (std::size_t i = 0; i < kMost; ++i) {
    descents_[i].relative = &poses_[i];
  }
  for (std::size_t k = 0; k < kTraversals; ++k) {
    taken_[k] = &poses_[kMost + k];
  }
}

void BatchedRootDescent::add(const WideTree& x, const Pose& pose_x, const ReferenceFrame& y) {
  RootDescent& descent = descents_[count_++];
  descent.relative->emplace(x, pose_x, y);
  descent.stack.clear();
  descent.seeds.clear();
  descent.cost = {};
  descent.cost.node_tests = 1;
  descent.node = 0;
}

void BatchedRootDescent::look(const WideTree& y) {
  const WideNode* const nodes = y.nodes().data();
  std::size_t going = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    RootDescent& descent = descents_[i];
    if ((*descent.relative)->apart()) {
      continue;
    }
    descent.box = (*descent.relative)->single_box();
    if (descent.box.pays(nodes[0])) {
      going_[going++] = &descent;
    } else {
      descent.seeds.push({0, 0});
    }
  }
  if (!y.min_max_grid().empty()) {
    // Without a branch on what was found, so that the next look need not wait for this one.
    std::array<bool, kMost> clear = {};
    for (std::size_t i = 0; i < going; ++i) {
      clear[i] = going_[i]->box.clear_of(y.min_max_grid());
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < going; ++i) {
      going_[left] = going_[i];
      left += clear[i] ? 0U : 1U;
    }
    going = left;
  }
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
