#include "apps/view/control/frame_times.h"

#include <algorithm>
#include <numeric>

namespace soms::view {

namespace {

constexpr double kRest = 0.5;

}  // namespace

void FrameTimes::add(double ms, double seconds) {
  ms_[next_] = static_cast<float>(ms);
  next_ = (next_ + 1) % kKept;
  count_ = std::min(count_ + 1, kKept);
  if (seconds > kRest) {
    running_ = 0;
    return;
  }
  intervals_[next_interval_] = seconds;
  next_interval_ = (next_interval_ + 1) % kIntervals;
  running_ = std::min(running_ + 1, kIntervals);
}

std::array<float, FrameTimes::kKept> FrameTimes::graph() const {
  std::array<float, kKept> ordered{};
  for (std::size_t i = 0; i < kKept; ++i) {
    ordered[i] = ms_[(next_ + i) % kKept];
  }
  return ordered;
}

double FrameTimes::mean() const {
  const double sum = std::accumulate(ms_.begin(), ms_.end(), 0.0);
  return count_ == 0 ? 0 : sum / static_cast<double>(count_);
}

double FrameTimes::greatest() const {
  return *std::max_element(ms_.begin(), ms_.end());
}

double FrameTimes::frames_a_second() const {
  double sum = 0;
  for (std::size_t i = 0; i < running_; ++i) {
    sum += intervals_[(next_interval_ + kIntervals - 1 - i) % kIntervals];
  }
  return sum > 0 ? static_cast<double>(running_) / sum : 0;
}

}  // namespace soms::view
