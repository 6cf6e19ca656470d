// Four lanes of NEON. Included inside a namespace, after <arm_neon.h>; see nodes.h.

struct M4 {
  uint32x4_t v;
};

inline M4 operator|(M4 a, M4 b) {
  return {vorrq_u32(a.v, b.v)};
}

inline M4 operator&(M4 a, M4 b) {
  return {vandq_u32(a.v, b.v)};
}

inline M4 operator^(M4 a, M4 b) {
  return {veorq_u32(a.v, b.v)};
}

inline std::uint32_t bits(M4 m) {
  const uint32x4_t weights = {1, 2, 4, 8};
  return vaddvq_u32(vandq_u32(m.v, weights));
}

struct F4 {
  F4() = default;

  explicit F4(float32x4_t x) : v(x) {}

  explicit F4(float x) : v(vdupq_n_f32(x)) {}

  static F4 load(const float* from) { return F4(vld1q_f32(from)); }

  static F4 gather(const float* from, const std::uint32_t* at) {
    return F4(float32x4_t{from[at[0]], from[at[1]], from[at[2]], from[at[3]]});
  }

  void store(float* to) const { vst1q_f32(to, v); }

  float32x4_t v;
};

inline F4 operator+(F4 a, F4 b) {
  return F4(vaddq_f32(a.v, b.v));
}

inline F4 operator-(F4 a, F4 b) {
  return F4(vsubq_f32(a.v, b.v));
}

inline F4 operator*(F4 a, F4 b) {
  return F4(vmulq_f32(a.v, b.v));
}

inline F4 operator/(F4 a, F4 b) {
  return F4(vdivq_f32(a.v, b.v));
}

inline F4 sqrt(F4 a) {
  return F4(vsqrtq_f32(a.v));
}

inline M4 operator>(F4 a, F4 b) {
  return {vcgtq_f32(a.v, b.v)};
}

// NEON's own minimum and maximum treat zeros and what is not a number otherwise than SSE's.
inline F4 min(F4 a, F4 b) {
  return F4(vbslq_f32(vcltq_f32(a.v, b.v), a.v, b.v));
}

inline F4 max(F4 a, F4 b) {
  return F4(vbslq_f32(vcgtq_f32(a.v, b.v), a.v, b.v));
}

inline F4 abs(F4 a) {
  return F4(vabsq_f32(a.v));
}

inline F4 select(M4 where, F4 a, F4 b) {
  return F4(vbslq_f32(where.v, a.v, b.v));
}

/// Lane k takes what lane (k + R) mod 4 held.
template <int R>
inline F4 rotate(F4 a) {
  return F4(vextq_f32(a.v, a.v, R));
}

inline F4 with_last(F4 a, float x) {
  return F4(vsetq_lane_f32(x, a.v, 3));
}
