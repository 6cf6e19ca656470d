#include "soms/scene/detail/rebuild_interval.h"

#include <algorithm>

namespace soms::detail {

namespace {

/// Looking at a pair costs this part of an entry.
constexpr double kPairCost = 0.2;
/// Boxes that move this many times as far as before have jumped: earlier motions predict nothing.
constexpr double kJump = 4;
constexpr std::uint32_t kRest = 32;

}  // namespace

std::uint32_t RebuildInterval::next(double speed) {
  const bool jumped = speed > kJump * speed_ && speed_ > 0;
  // After a jump, the next call goes back to the length from before it.
  if (jumped) {
    calls_ = 0;
    speed_ = 0;
    return 0;
  }
  speed_ = speed;
  if (calls_ == 0 && kLengths[at_] != 0) {
    calls_ = kLengths[at_];  // boxes had no motions to judge by
    return calls_;
  }
  const double cost =
      static_cast<double>(spent_) / static_cast<double>(std::max<std::uint64_t>(1, age_)) +
      kPairCost * static_cast<double>(pairs_);
  if (last_cost_ > 0 && cost > last_cost_) {
    up_ = !up_;
  }
  last_cost_ = cost;
  if (at_ == 0) {
    up_ = true;
    if (rest_ > 0) {
      --rest_;
    } else {
      at_ = 1;
      last_cost_ = 0;
    }
  } else if (up_) {
    at_ = std::min(at_ + 1, kLengths.size() - 1);
  } else {
    --at_;
    rest_ = at_ == 0 ? kRest : 0;
  }
  calls_ = kLengths[at_];
  return calls_;
}

void RebuildInterval::look_less_far() {
  at_ = at_ > 2 ? at_ - 2 : 0;
  up_ = false;
  last_cost_ = 0;
  calls_ = 0;
}

void RebuildInterval::start(std::uint64_t work, std::uint64_t pairs) {
  age_ = 0;
  spent_ = work;
  pairs_ = pairs;
}

}  // namespace soms::detail
