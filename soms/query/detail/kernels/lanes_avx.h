// Eight lanes of AVX. Included inside a namespace, after <immintrin.h>; see triangles.h.

struct M8 {
  __m256 v;
};

inline M8 operator|(M8 a, M8 b) {
  return {_mm256_or_ps(a.v, b.v)};
}

inline M8 operator&(M8 a, M8 b) {
  return {_mm256_and_ps(a.v, b.v)};
}

inline M8 operator^(M8 a, M8 b) {
  return {_mm256_xor_ps(a.v, b.v)};
}

inline std::uint32_t bits(M8 m) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(m.v));
}

struct F8 {
  F8() = default;

  explicit F8(__m256 x) : v(x) {}

  explicit F8(float x) : v(_mm256_set1_ps(x)) {}

  static F8 load(const float* from) { return F8(_mm256_loadu_ps(from)); }

  static F8 gather(const float* from, const std::uint32_t* at) {
    return F8(_mm256_i32gather_ps(from, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(at)),
                                  sizeof(float)));
  }

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
  return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)};
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
  return F8(_mm256_blendv_ps(b.v, a.v, where.v));
}

/// Four lanes, again and again.
inline F8 repeated(F4 a) {
  return F8(_mm256_insertf128_ps(_mm256_castps128_ps256(a.v), a.v, 1));
}

/// Four lanes turned by R, then by one more.
template <int R>
inline F8 rotations(F4 a) {
  return F8(_mm256_insertf128_ps(_mm256_castps128_ps256(rotate<R>(a).v), rotate<R + 1>(a).v, 1));
}

/// The most lanes that are worked on at once.
using Wide = F8;
using WideMask = M8;
