/// \file
/// A long query of nearness in parts, which several threads may look at.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/detail/near/near_goal.h"
#include "soms/query/detail/near/near_pose.h"
#include "soms/query/detail/near/near_traversal.h"

#include <memory>
#include <vector>

namespace soms::detail {

/// Goes on with a traversal, wave by wave. Each wave takes the nearest pairs, deals them out to a
/// fixed number of parts, and has each part traverse for a fixed number of steps with what is known
/// when the wave begins; what parts find and leave is taken back in their order. So the answer, its
/// cost included, is the same for any number of threads, one included.
template <class Source>
class NearWaves {
 public:
  NearWaves(const PairFrame& frame, const NearPose& pose, const NearGoal& goal);
  NearWaves(const NearWaves&) = delete;
  NearWaves& operator=(const NearWaves&) = delete;
  ~NearWaves();

  /// Until the end, or until the deadline ends it. \pre whole.sorted()
  /// \errors ErrorKind::cancelled.
  void run(NearTraversal<Source>& whole, const Limits& limits);

 private:
  struct Part;

  /// True while there is more to be done.
  [[nodiscard]] bool wave(NearTraversal<Source>& whole, const Limits& limits);

  const PairFrame& frame_;
  const NearPose& pose_;
  const NearGoal& goal_;
  std::vector<std::unique_ptr<Part>> parts_;
  std::vector<KeyedPair> given_;
};

extern template class NearWaves<WideSource>;
extern template class NearWaves<CompactSource>;

}  // namespace soms::detail
