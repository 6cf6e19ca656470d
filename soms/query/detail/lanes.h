/// \file
/// Four floats or masks side by side, in the compilers' own vector types: every lane is rounded as
/// a float is, on every target.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace soms::detail {

/// Four floats.
using F4 [[gnu::vector_size(16)]] = float;
/// Four masks: all bits of a lane set, or none.
using M4 [[gnu::vector_size(16)]] = std::int32_t;

[[nodiscard]] inline F4 load(const std::array<float, 4>& from) {
  F4 v;
  std::memcpy(&v, from.data(), sizeof v);
  return v;
}

[[nodiscard]] inline F4 splat(float x) {
  return F4{x, x, x, x};
}

[[nodiscard]] inline F4 abs(F4 v) {
  M4 bits;
  std::memcpy(&bits, &v, sizeof bits);
  bits &= 0x7fffffff;
  std::memcpy(&v, &bits, sizeof v);
  return v;
}

/// Lane k takes what lane (k + N) mod 4 held.
template <int N>
[[nodiscard]] inline F4 rotate(F4 v) {
  return __builtin_shufflevector(v, v, N & 3, (N + 1) & 3, (N + 2) & 3, (N + 3) & 3);
}

/// Bit k is set where lane k of a mask is.
[[nodiscard]] inline std::uint32_t bits_of(M4 mask) {
#if defined(__SSE2__)
  __m128 lanes;
  std::memcpy(&lanes, &mask, sizeof lanes);
  return static_cast<std::uint32_t>(_mm_movemask_ps(lanes));
#else
  return (mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8);
#endif
}

}  // namespace soms::detail
