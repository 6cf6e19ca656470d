/// \file
/// Times at which two moving things may meet: an interval, cut by direction after direction.
#pragma once

#include "soms/motion/detail/motion_bounds.h"

namespace soms::detail {

/// Times in [-1, 1], from the begin of a stretch of the way to its end; see motion_bounds.h.
struct TimeWindow {
  double lower = -1;
  double upper = 1;
};

}  // namespace soms::detail
