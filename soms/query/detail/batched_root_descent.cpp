#include "soms/query/detail/batched_root_descent.h"

#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/engine/node_id.h"

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

BatchedRootDescent::BatchedRootDescent() {
  for (std::size_t i = 0; i < kMost; ++i) {
    descents_[i].frame = &frames_[i];
  }
  for (std::size_t k = 0; k < kTraversals; ++k) {
    taken_[k] = &frames_[kMost + k];
  }
}

void BatchedRootDescent::add(const PoseFrames& frames, const Pose& pose) {
  RootDescent& descent = descents_[count_++];
  frames.place(pose, *descent.frame);
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
    const RelativePose& relative = (*descent.frame)->relative();
    if (relative.apart()) {
      continue;
    }
    descent.box = relative.single_box();
    if (descent.box.pays(nodes[0])) {
      going_[going++] = &descent;
    } else {
      descent.seeds.push({kRootId, kRootId});
    }
  }
  if (!y.min_max_grid().empty()) {
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
  going = begun;
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
