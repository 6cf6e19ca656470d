/// \file
/// Times at which two moving things may meet along a direction: an interval, cut by direction after
/// direction.
#pragma once

#include "soms/motion/detail/motion_bounds.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

/// Times in [-1, 1], from the begin of a stretch of the way to its end; see motion_bounds.h.
struct TimeWindow {
  double lower = -1;
  double upper = 1;

  [[nodiscard]] bool empty() const { return !(lower <= upper); }

  /// Leaves the times s with |p - s w| <= r, and the next ones. Where nothing moves along the
  /// direction, as along one of length 0, that is all of them or none. \pre r >= 0
  void narrow(double p, double w, double r) {
    if (w == 0) {
      upper = std::abs(p) <= r ? upper : -2;
      return;
    }
    const double a = (p - r) / w;
    const double b = (p + r) / w;
    lower = std::max(lower, std::min(a, b) - kWindowMargin);
    upper = std::min(upper, std::max(a, b) + kWindowMargin);
  }
};

}  // namespace soms::detail
