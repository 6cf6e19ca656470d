// Four lanes of WebAssembly's SIMD128. Included inside a namespace, after <wasm_simd128.h>; see
// nodes.h.

struct M4 {
  v128_t v;
};

inline M4 operator|(M4 a, M4 b) {
  return {wasm_v128_or(a.v, b.v)};
}

inline M4 operator&(M4 a, M4 b) {
  return {wasm_v128_and(a.v, b.v)};
}

inline M4 operator^(M4 a, M4 b) {
  return {wasm_v128_xor(a.v, b.v)};
}

inline std::uint32_t bits(M4 m) {
  return static_cast<std::uint32_t>(wasm_i32x4_bitmask(m.v));
}

struct F4 {
  F4() = default;

  explicit F4(v128_t x) : v(x) {}

  explicit F4(float x) : v(wasm_f32x4_splat(x)) {}

  static F4 load(const float* from) { return F4(wasm_v128_load(from)); }

  static F4 gather(const float* from, const std::uint32_t* at) {
    return F4(wasm_f32x4_make(from[at[0]], from[at[1]], from[at[2]], from[at[3]]));
  }

  void store(float* to) const { wasm_v128_store(to, v); }

  v128_t v;
};

inline F4 operator+(F4 a, F4 b) {
  return F4(wasm_f32x4_add(a.v, b.v));
}

inline F4 operator-(F4 a, F4 b) {
  return F4(wasm_f32x4_sub(a.v, b.v));
}

inline F4 operator*(F4 a, F4 b) {
  return F4(wasm_f32x4_mul(a.v, b.v));
}

inline F4 operator/(F4 a, F4 b) {
  return F4(wasm_f32x4_div(a.v, b.v));
}

inline F4 sqrt(F4 a) {
  return F4(wasm_f32x4_sqrt(a.v));
}

inline M4 operator>(F4 a, F4 b) {
  return {wasm_f32x4_gt(a.v, b.v)};
}

// pmin(x, y) is y < x ? y : x and pmax(x, y) is x < y ? y : x: with their arguments exchanged they
// are SSE's minimum and maximum, of zeros and of what is not a number, too.
inline F4 min(F4 a, F4 b) {
  return F4(wasm_f32x4_pmin(b.v, a.v));
}

inline F4 max(F4 a, F4 b) {
  return F4(wasm_f32x4_pmax(b.v, a.v));
}

inline F4 abs(F4 a) {
  return F4(wasm_f32x4_abs(a.v));
}

inline F4 select(M4 where, F4 a, F4 b) {
  return F4(wasm_v128_bitselect(a.v, b.v, where.v));
}

/// Lane k takes what lane (k + R) mod 4 held.
template <int R>
inline F4 rotate(F4 a) {
  return F4(wasm_i32x4_shuffle(a.v, a.v, R & 3, (R + 1) & 3, (R + 2) & 3, (R + 3) & 3));
}

inline F4 with_last(F4 a, float x) {
  return F4(wasm_f32x4_replace_lane(a.v, 3, x));
}
