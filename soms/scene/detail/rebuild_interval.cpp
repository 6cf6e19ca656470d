#include "soms/scene/detail/rebuild_interval.h"

#include <algorithm>
#include <limits>

namespace soms::detail {

namespace {

// Costs in entries of a grid: to look at a kept pair in a call, and to find and sort one.
constexpr double kPairCost = 0.25;
constexpr double kNewPairCost = 0.6;
/// Rebuilding costs so much besides, however few boxes there are.
constexpr double kRebuildCost = 1000;
/// Boxes that move this many times as far as before have jumped: earlier motions predict nothing.
constexpr double kJump = 4;
/// Rebuilt so many times in a row without use, boxes are again made larger.
constexpr std::uint32_t kRest = 32;
/// The expected number of pairs is corrected by no more than this.
constexpr double kMostError = 64;

double growth_of_pairs(const Outlook& outlook, double calls) {
  return (1 + outlook.growth[0] * calls) * (1 + outlook.growth[1] * calls) *
         (1 + outlook.growth[2] * calls);
}

}  // namespace

/// From how long the larger boxes held all boxes.
void RebuildInterval::learn() {
  if (calls_ == 0) {
    return;
  }
  const std::uint64_t served = age_ - 1;
  if (served >= calls_) {
    most_ = std::min(std::max(most_, 2 * calls_), kLengths.back());
  } else if (2 * served < calls_) {
    most_ = static_cast<std::uint32_t>(std::min<std::uint64_t>(served, kLengths.back()));
    rest_ = most_ == 0 ? kRest : 0;
  }
}

std::uint32_t RebuildInterval::next(const Outlook& outlook) {
  const bool jumped = outlook.last > kJump * speed_ && speed_ > 0;
  if (jumped) {
    calls_ = 0;
    speed_ = 0;
    return 0;
  }
  speed_ = outlook.speed;
  learn();
  if (rest_ > 0) {
    --rest_;
    most_ = rest_ == 0 ? 1 : 0;
  }
  calls_ = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t calls : kLengths) {
    if (calls > most_) {
      break;
    }
    const auto ahead = static_cast<double>(calls);
    const double growth = growth_of_pairs(outlook, ahead);
    const double pairs = static_cast<double>(found_ + 1) * growth * (calls > 0 ? error_ : 1);
    const double cost =
        (kRebuildCost + static_cast<double>(work_) + kNewPairCost * pairs) / (ahead + 1) +
        kPairCost * pairs;
    if (cost < least) {
      least = cost;
      calls_ = calls;
      growth_ = growth;
    }
  }
  return calls_;
}

void RebuildInterval::look_less_far() {
  most_ = calls_ / 2;
  rest_ = most_ == 0 ? kRest : 0;
  calls_ = 0;
}

void RebuildInterval::start(std::uint64_t work, std::uint64_t pairs) {
  if (calls_ > 0) {
    const double expected = growth_ * static_cast<double>(found_ + 1);
    error_ = std::clamp(static_cast<double>(pairs + 1) / expected, 1 / kMostError, kMostError);
  }
  age_ = 0;
  work_ = work;
}

}  // namespace soms::detail
