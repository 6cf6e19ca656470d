/// \file
/// Points and boxes in four lanes, for builders and layouts: x, y, z and something that is ignored.
#pragma once

#include "soms/base/lanes.h"

#include <cstdint>
#include <cstring>

namespace soms::lanes {

/// Four floats from any address that holds 16 bytes.
[[nodiscard]] inline F4 load(const void* from) {
  F4 v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Lane 3 becomes 0.
[[nodiscard]] inline F4 first_three(F4 v) {
  using Bits [[gnu::vector_size(16)]] = std::int32_t;
  Bits bits;
  std::memcpy(&bits, &v, sizeof bits);
  bits &= Bits{-1, -1, -1, 0};
  std::memcpy(&v, &bits, sizeof v);
  return v;
}

/// A box in the first three lanes; empty at first.
struct Box4 {
  F4 lower = splat(__builtin_inff());
  F4 upper = splat(-__builtin_inff());

  void grow(F4 low, F4 high) {
    lower = min(lower, low);
    upper = max(upper, high);
  }

  void grow(F4 point) { grow(point, point); }

  void grow(const Box4& other) { grow(other.lower, other.upper); }

  [[nodiscard]] float half_area() const {
    const F4 d = upper - lower;
    const F4 product = d * __builtin_shufflevector(d, d, 1, 2, 0, 3);
    return (product[0] + product[1]) + product[2];
  }
};

}  // namespace soms::lanes
