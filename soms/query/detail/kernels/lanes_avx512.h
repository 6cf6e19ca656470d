// Eight lanes of AVX-512, whose comparisons give masks. Included inside a namespace, after
// <immintrin.h>; see triangles.h.

struct M8 {
  __mmask8 v;
};

inline M8 operator|(M8 a, M8 b) {
  return {_kor_mask8(a.v, b.v)};
}

inline M8 operator&(M8 a, M8 b) {
  return {_kand_mask8(a.v, b.v)};
}

inline std::uint32_t bits(M8 m) {
  return m.v;
}

struct F8 {
  F8() = default;

  explicit F8(__m256 x) : v(x) {}

  explicit F8(float x) : v(_mm256_set1_ps(x)) {}

  static F8 load(const float* from) { return F8(_mm256_loadu_ps(from)); }

  void store(float* to) const { _mm256_storeu_ps(to, v); }

  __m256 v;
};

inline F8 operator+(F8 a, F8 b) {
  return F8(_mm256_add_ps(a.v, b.v));
}

inline F8 operator-(F8 a, F8 b) {
  return F8(_mm256_sub_ps(a.v, b.v));
}

inline F8 operator*(F8 a, F8 b) {
  return F8(_mm256_mul_ps(a.v, b.v));
}

inline F8 operator/(F8 a, F8 b) {
  return F8(_mm256_div_ps(a.v, b.v));
}

inline F8 sqrt(F8 a) {
  return F8(_mm256_sqrt_ps(a.v));
}

inline M8 operator>(F8 a, F8 b) {
  return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)};
}

inline F8 min(F8 a, F8 b) {
  return F8(_mm256_min_ps(a.v, b.v));
}

inline F8 max(F8 a, F8 b) {
  return F8(_mm256_max_ps(a.v, b.v));
}

inline F8 abs(F8 a) {
  return F8(_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v));
}

inline F8 select(M8 where, F8 a, F8 b) {
  return F8(_mm256_mask_blend_ps(where.v, b.v, a.v));
}
