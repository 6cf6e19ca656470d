#include "soms/query/detail/near/near_query.h"

#include "soms/base/error.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/near/far_search.h"
#include "soms/query/detail/near/near_waves.h"

#include <cstdint>

namespace soms::detail {

namespace {

/// Steps of a query that is not worth parts: about 10 ms.
constexpr std::uint64_t kWholeSteps = 8192;

template <class Source>
NearEnd traverse(PairFrame& frame, NearGoal& goal, const Limits& limits, NearMemory& memory) {
  NearPose pose(frame);
  Limit limit(limits);
  Cost cost;
  if (pose.far()) {
    FarSearch<Source> search(frame, goal);
    const bool complete = search.run(limit);
    cost = search.cost();
    if (complete) {
      return {true, goal.upper(), cost};
    }
  }
  NearTraversal<Source> traversal(frame, pose, goal, memory);
  traversal.start();
  bool ended = traversal.run(limit, kWholeSteps);
  while (!ended && !traversal.sorted()) {
    ended = traversal.run(limit, kWholeSteps);
  }
  if (!ended) {
    NearWaves<Source>(frame, pose, goal).run(traversal, limits);
  }
  cost += traversal.cost();
  return {traversal.complete(), traversal.at_least(), cost};
}

}  // namespace

NearEnd pursue(PairFrame& frame, NearGoal& goal, const Limits& limits, NearMemory& memory) {
  return any_compact(*frame.x().shape, *frame.y().shape)
             ? traverse<CompactSource>(frame, goal, limits, memory)
             : traverse<WideSource>(frame, goal, limits, memory);
}

NearBatch::NearBatch(const Shape& mover, const Body& fixed)
    : memory_(std::make_unique<NearMemory>()) {
  if (!is_empty(mover) && !is_empty(fixed.shape)) {
    frames_.emplace(mover, fixed);
  }
}

PairFrame& NearBatch::place(const Pose& pose) {
  frames_->place(pose, frame_);
  return *frame_;
}

void check_length(double length, const char* what) {
  if (!(length >= 0)) {
    throw Error(ErrorKind::usage, std::string(what) + " is negative or not a number",
                "give 0 or more");
  }
}

}  // namespace soms::detail
