/// \file
/// Arguments as JavaScript hands them in.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <span>

namespace soms::web {

static_assert(sizeof(Pose) == 12 * sizeof(double) && sizeof(Vec3) == 3 * sizeof(double));

/// A deadline after so many milliseconds; none where they are infinite.
[[nodiscard]] inline Limits within_time(double milliseconds) {
  constexpr double kYear = 3e10;
  Limits limits;
  if (milliseconds < kYear) {
    limits.deadline = std::chrono::steady_clock::now() +
                      std::chrono::microseconds(static_cast<std::int64_t>(milliseconds * 1000));
  }
  return limits;
}

}  // namespace soms::web
