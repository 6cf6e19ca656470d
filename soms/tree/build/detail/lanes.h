/// \file
/// Four floats side by side, in the compilers' own vector types, for builders and layouts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace soms::lanes {

/// Four floats; builders keep x, y, z and something that they ignore.
using F4 [[gnu::vector_size(16)]] = float;

[[nodiscard]] inline F4 splat(float x) {
  return F4{x, x, x, x};
}

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

/// `a < b ? a : b` in each lane.
[[nodiscard]] inline F4 min(F4 a, F4 b) {
#if defined(__SSE2__)
  return _mm_min_ps(a, b);
#else
  return F4{a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1], a[2] < b[2] ? a[2] : b[2],
            a[3] < b[3] ? a[3] : b[3]};
#endif
}

/// `a > b ? a : b` in each lane.
[[nodiscard]] inline F4 max(F4 a, F4 b) {
#if defined(__SSE2__)
  return _mm_max_ps(a, b);
#else
  return F4{a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1], a[2] > b[2] ? a[2] : b[2],
            a[3] > b[3] ? a[3] : b[3]};
#endif
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
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

}  // namespace soms::lanes
