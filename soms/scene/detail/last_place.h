/// \file
/// Where a mover was when the last step ended.
#pragma once

#include "soms/base/pose.h"

#include <cstdint>

namespace soms::detail {

/// Kept by the count of steps, so that a step has nothing to write down for movers that rest. A
/// body that is added, or has another shape, has no place until the next step.
class LastPlace {
 public:
  LastPlace() = default;

  /// There is none until more than `steps` steps are done.
  explicit LastPlace(std::uint64_t steps) : steps_(steps) {}

  /// The body leaves `pose`, after so many steps.
  void leave(const Pose& pose, std::uint64_t steps) {
    if (steps_ != steps) {
      *this = LastPlace(steps);
      pose_ = pose;
      known_ = true;
    }
  }

  /// The pose at the last of so many steps, if the body has left it since for `now`; else nothing.
  [[nodiscard]] const Pose* left_for(const Pose& now, std::uint64_t steps) const {
    return known_ && steps_ == steps && pose_ != now ? &pose_ : nullptr;
  }

 private:
  Pose pose_;
  std::uint64_t steps_ = 0;  ///< done when the rest was set
  bool known_ = false;
};

}  // namespace soms::detail
