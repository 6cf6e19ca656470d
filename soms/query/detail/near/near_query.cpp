#include "soms/query/detail/near/near_query.h"

#include "soms/base/error.h"
#include "soms/query/detail/engine/limit.h"

namespace soms::detail {

namespace {

template <class Source>
NearEnd traverse(PairFrame& frame, NearPose& pose, NearGoal& goal, Limit& limit,
                 NearMemory& memory) {
  NearTraversal<Source> traversal(frame, pose, goal, memory);
  traversal.run(limit);
  return {traversal.complete(), traversal.at_least(), traversal.cost()};
}

}  // namespace

NearEnd pursue(PairFrame& frame, NearGoal& goal,
               std::optional<std::chrono::steady_clock::time_point> deadline,
               const Parallel& parallel, NearMemory& memory) {
  Limit limit(deadline, parallel);
  NearPose pose(frame);
  return any_compact(*frame.x().shape, *frame.y().shape)
             ? traverse<CompactSource>(frame, pose, goal, limit, memory)
             : traverse<WideSource>(frame, pose, goal, limit, memory);
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
