/// \file
/// What two boxes have in common.
#pragma once

#include "soms/base/box.h"

#include <algorithm>

namespace soms {

/// The intersection of two closed boxes; empty where they are apart.
[[nodiscard]] constexpr Box common_box(const Box& a, const Box& b) {
  return {.lower = {std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y),
                    std::max(a.lower.z, b.lower.z)},
          .upper = {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y),
                    std::min(a.upper.z, b.upper.z)}};
}

}  // namespace soms
