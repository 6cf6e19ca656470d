// Sixteen lanes of AVX-512. Included inside a namespace, after <immintrin.h>; see triangle_pairs.h.

struct M16 {
  __mmask16 v;
};

inline M16 operator|(M16 a, M16 b) {
  return {_kor_mask16(a.v, b.v)};
}

inline M16 operator&(M16 a, M16 b) {
  return {_kand_mask16(a.v, b.v)};
}

inline M16 operator^(M16 a, M16 b) {
  return {_kxor_mask16(a.v, b.v)};
}

inline std::uint32_t bits(M16 m) {
  return m.v;
}

struct F16 {
  F16() = default;

  explicit F16(__m512 x) : v(x) {}

  explicit F16(float x) : v(_mm512_set1_ps(x)) {}

  static F16 gather(const float* from, const std::uint32_t* at) {
    return F16(_mm512_i32gather_ps(_mm512_loadu_si512(at), from, sizeof(float)));
  }

  void store(float* to) const { _mm512_storeu_ps(to, v); }

  __m512 v;
};

inline F16 operator+(F16 a, F16 b) {
  return F16(_mm512_add_ps(a.v, b.v));
}

inline F16 operator-(F16 a, F16 b) {
  return F16(_mm512_sub_ps(a.v, b.v));
}

inline F16 operator*(F16 a, F16 b) {
  return F16(_mm512_mul_ps(a.v, b.v));
}

inline F16 operator/(F16 a, F16 b) {
  return F16(_mm512_div_ps(a.v, b.v));
}

inline F16 sqrt(F16 a) {
  return F16(_mm512_sqrt_ps(a.v));
}

inline M16 operator>(F16 a, F16 b) {
  return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)};
}

inline F16 min(F16 a, F16 b) {
  return F16(_mm512_min_ps(a.v, b.v));
}

inline F16 max(F16 a, F16 b) {
  return F16(_mm512_max_ps(a.v, b.v));
}

inline F16 abs(F16 a) {
  return F16(_mm512_abs_ps(a.v));
}

inline F16 select(M16 where, F16 a, F16 b) {
  return F16(_mm512_mask_blend_ps(where.v, b.v, a.v));
}

/// Four lanes, again and again.
inline F16 repeated(F4 a) {
  return F16(_mm512_broadcast_f32x4(a.v));
}

/// Four lanes, then turned by one, by two and by three.
template <int R>
inline F16 rotations(F4 a) {
  static_assert(R == 0);
  const __m512i from = _mm512_setr_epi32(0, 1, 2, 3, 1, 2, 3, 0, 2, 3, 0, 1, 3, 0, 1, 2);
  return F16(_mm512_permutexvar_ps(from, _mm512_castps128_ps512(a.v)));
}

/// The most lanes that are worked on at once.
using Wide = F16;
using WideMask = M16;
