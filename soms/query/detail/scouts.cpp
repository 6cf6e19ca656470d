#include "soms/query/detail/scouts.h"

#include "soms/query/detail/fetch.h"
#include "soms/query/detail/kernels/kernels.h"

namespace soms::detail {

namespace {

/// Starts to load what the walk of a query will look at first.
void fetch_seeds(const PairList& seeds, const WideTree& y) {
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::uint32_t code = seeds.at(i).y;
    const WideNode& node = y.nodes()[code >> 3];
    if ((code & NodeTask::kLane) != 0) {
      fetch(y.blocks()[node.child[code & 3] & (WideNode::kMost - 1)]);
    } else {
      fetch(node);
    }
  }
}

}  // namespace

Scouts::Scouts() {
  for (std::size_t i = 0; i < kMost; ++i) {
    scouts_[i].relative = &poses_[i];
  }
  for (std::size_t k = 0; k < kWalks; ++k) {
    taken_[k] = &poses_[kMost + k];
  }
}

void Scouts::add(const WideTree& x, const Pose& pose_x, const Viewer& y) {
  Scout& scout = scouts_[count_++];
  scout.relative->emplace(x, pose_x, y);
  scout.stack.clear();
  scout.seeds.clear();
  scout.cost = {};
  scout.cost.node_tests = 1;
  scout.node = 0;
}

void Scouts::look(const WideTree& y) {
  const WideNode* const nodes = y.nodes().data();
  std::size_t going = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    Scout& scout = scouts_[i];
    if ((*scout.relative)->apart()) {
      continue;
    }
    scout.box = (*scout.relative)->lone_box();
    if (scout.box.pays(nodes[0])) {
      going_[going++] = &scout;
    } else {
      scout.seeds.push({0, 0});
    }
  }
  if (!y.columns().empty()) {
    // Without a branch on what was found, so that the next look need not wait for this one.
    std::array<bool, kMost> clear = {};
    for (std::size_t i = 0; i < going; ++i) {
      clear[i] = going_[i]->box.clear_of(y.columns());
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
      Scout& scout = *going_[i];
      if (scout.box.step(nodes, scout.node, scout.stack, scout.seeds, scout.cost)) {
        ++i;
      } else {
        fetch_seeds(scout.seeds, y);
        going_[i] = going_[--going];
      }
    }
  }
}

}  // namespace soms::detail
