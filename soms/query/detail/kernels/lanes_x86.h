// Four lanes of SSE, and the packing of those that survive. Included inside a namespace, after
// <immintrin.h>; see nodes.h.

struct M4 {
  __m128 v;
};

inline M4 operator|(M4 a, M4 b) {
  return {_mm_or_ps(a.v, b.v)};
}

inline M4 operator&(M4 a, M4 b) {
  return {_mm_and_ps(a.v, b.v)};
}

inline M4 operator^(M4 a, M4 b) {
  return {_mm_xor_ps(a.v, b.v)};
}

inline std::uint32_t bits(M4 m) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(m.v));
}

struct F4 {
  F4() = default;

  explicit F4(__m128 x) : v(x) {}

  explicit F4(float x) : v(_mm_set1_ps(x)) {}

  static F4 load(const float* from) { return F4(_mm_loadu_ps(from)); }

  static F4 gather(const float* from, const std::uint32_t* at) {
    return F4(_mm_setr_ps(from[at[0]], from[at[1]], from[at[2]], from[at[3]]));
  }

  void store(float* to) const { _mm_storeu_ps(to, v); }

  __m128 v;
};

inline F4 operator+(F4 a, F4 b) {
  return F4(_mm_add_ps(a.v, b.v));
}

inline F4 operator-(F4 a, F4 b) {
  return F4(_mm_sub_ps(a.v, b.v));
}

inline F4 operator*(F4 a, F4 b) {
  return F4(_mm_mul_ps(a.v, b.v));
}

inline F4 operator/(F4 a, F4 b) {
  return F4(_mm_div_ps(a.v, b.v));
}

inline F4 sqrt(F4 a) {
  return F4(_mm_sqrt_ps(a.v));
}

inline M4 operator>(F4 a, F4 b) {
  return {_mm_cmpgt_ps(a.v, b.v)};
}

inline F4 min(F4 a, F4 b) {
  return F4(_mm_min_ps(a.v, b.v));
}

inline F4 max(F4 a, F4 b) {
  return F4(_mm_max_ps(a.v, b.v));
}

inline F4 abs(F4 a) {
  return F4(_mm_andnot_ps(_mm_set1_ps(-0.0F), a.v));
}

inline F4 select(M4 where, F4 a, F4 b) {
  return F4(_mm_blendv_ps(b.v, a.v, where.v));
}

/// Lane k takes what lane (k + R) mod 4 held.
template <int R>
inline F4 rotate(F4 a) {
  return F4(_mm_shuffle_ps(a.v, a.v, _MM_SHUFFLE((R + 3) & 3, (R + 2) & 3, (R + 1) & 3, R)));
}

inline F4 with_last(F4 a, float x) {
  return F4(_mm_insert_ps(a.v, _mm_set_ss(x), 0x30));
}
