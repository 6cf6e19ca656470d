/// \file
/// What the queries of nearness share: one traversal for a goal, and the check of a length.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/answer.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/near/near_goal.h"
#include "soms/query/detail/near/near_traversal.h"

#include <memory>
#include <optional>

namespace soms::detail {

/// How a traversal ended.
struct NearEnd {
  bool complete = false;
  double at_least = 0;  ///< nothing that was left out is nearer
  Cost cost;
};

/// Traverses for a goal.
/// \errors ErrorKind::cancelled.
[[nodiscard]] NearEnd pursue(PairFrame& frame, NearGoal& goal, const Limits& limits,
                             NearMemory& memory);

/// What the poses of a batch that one thread asks share.
class NearBatch {
 public:
  NearBatch(const Shape& mover, const Body& fixed);

  /// The frame of the mover at `pose`; the one before is gone. \pre Neither mesh is empty.
  [[nodiscard]] PairFrame& place(const Pose& pose);

  [[nodiscard]] NearMemory& memory() { return *memory_; }

 private:
  std::optional<PoseFrames> frames_;
  std::optional<PairFrame> frame_;
  std::unique_ptr<NearMemory> memory_;
};

/// Throws ErrorKind::usage unless `length` is 0 or more, or infinity; `what` names it.
void check_length(double length, const char* what);

}  // namespace soms::detail
