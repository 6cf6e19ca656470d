/// \file
/// Four floats side by side, in the compilers' own vector types: every lane is rounded as a float
/// is, on every target.
#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace soms::lanes {

using F4 [[gnu::vector_size(16)]] = float;

[[nodiscard]] inline F4 splat(float x) {
  return F4{x, x, x, x};
}

/// `a < b ? a : b` in each lane.
[[nodiscard]] inline F4 min(F4 a, F4 b) {
#if defined(__SSE2__)
  return _mm_min_ps(a, b);
#elif defined(__wasm_simd128__)
  // wasm's pmin(x, y) is y < x ? y : x.
  return reinterpret_cast<F4>(
      wasm_f32x4_pmin(reinterpret_cast<v128_t>(b), reinterpret_cast<v128_t>(a)));
#else
  return F4{a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1], a[2] < b[2] ? a[2] : b[2],
            a[3] < b[3] ? a[3] : b[3]};
#endif
}

/// `a > b ? a : b` in each lane.
[[nodiscard]] inline F4 max(F4 a, F4 b) {
#if defined(__SSE2__)
  return _mm_max_ps(a, b);
#elif defined(__wasm_simd128__)
  // wasm's pmax(x, y) is x < y ? y : x.
  return reinterpret_cast<F4>(
      wasm_f32x4_pmax(reinterpret_cast<v128_t>(b), reinterpret_cast<v128_t>(a)));
#else
  return F4{a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1], a[2] > b[2] ? a[2] : b[2],
            a[3] > b[3] ? a[3] : b[3]};
#endif
}

}  // namespace soms::lanes
