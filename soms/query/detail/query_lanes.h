/// \file
/// Four floats or masks side by side, in the compilers' own vector types: every lane is rounded as
/// a float is, on every target.
#pragma once

#include "soms/base/lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace soms::detail {

using lanes::F4;
using lanes::max;
using lanes::min;
using lanes::splat;

/// Four masks: all bits of a lane set, or none.
using M4 [[gnu::vector_size(16)]] = std::int32_t;

/// Lanes `first` to `first + 3` of a row.
template <std::size_t N>
[[nodiscard]] inline F4 load(const std::array<float, N>& from, std::size_t first = 0) {
  F4 v;
  std::memcpy(&v, from.data() + first, sizeof v);
  return v;
}

template <std::size_t N>
inline void store(F4 v, std::array<float, N>& to, std::size_t first) {
  std::memcpy(to.data() + first, &v, sizeof v);
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
#elif defined(__wasm_simd128__)
  return wasm_i32x4_bitmask(reinterpret_cast<v128_t>(mask));
#else
  std::uint32_t bits = 0;
  for (int k = 0; k < 4; ++k) {
    bits |= static_cast<std::uint32_t>(mask[k] != 0) << k;
  }
  return bits;
#endif
}

}  // namespace soms::detail
