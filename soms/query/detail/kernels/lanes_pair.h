// Eight lanes as two times four. Included inside a namespace, after its F4; see triangles.h.

struct M8 {
  M4 low;
  M4 high;
};

inline M8 operator|(M8 a, M8 b) {
  return {a.low | b.low, a.high | b.high};
}

inline M8 operator&(M8 a, M8 b) {
  return {a.low & b.low, a.high & b.high};
}

inline M8 operator^(M8 a, M8 b) {
  return {a.low ^ b.low, a.high ^ b.high};
}

inline std::uint32_t bits(M8 m) {
  return bits(m.low) | bits(m.high) << 4;
}

struct F8 {
  F8() = default;

  F8(F4 a, F4 b) : low(a), high(b) {}

  explicit F8(float x) : low(x), high(x) {}

  static F8 load(const float* from) { return {F4::load(from), F4::load(from + 4)}; }

  static F8 gather(const float* from, const std::uint32_t* at) {
    return {F4::gather(from, at), F4::gather(from, at + 4)};
  }

  void store(float* to) const {
    low.store(to);
    high.store(to + 4);
  }

  F4 low;
  F4 high;
};

inline F8 operator+(F8 a, F8 b) {
  return {a.low + b.low, a.high + b.high};
}

inline F8 operator-(F8 a, F8 b) {
  return {a.low - b.low, a.high - b.high};
}

inline F8 operator*(F8 a, F8 b) {
  return {a.low * b.low, a.high * b.high};
}

inline F8 operator/(F8 a, F8 b) {
  return {a.low / b.low, a.high / b.high};
}

inline F8 sqrt(F8 a) {
  return {sqrt(a.low), sqrt(a.high)};
}

inline M8 operator>(F8 a, F8 b) {
  return {a.low > b.low, a.high > b.high};
}

inline F8 min(F8 a, F8 b) {
  return {min(a.low, b.low), min(a.high, b.high)};
}

inline F8 max(F8 a, F8 b) {
  return {max(a.low, b.low), max(a.high, b.high)};
}

inline F8 abs(F8 a) {
  return {abs(a.low), abs(a.high)};
}

inline F8 select(M8 where, F8 a, F8 b) {
  return {select(where.low, a.low, b.low), select(where.high, a.high, b.high)};
}

/// Four lanes, again and again.
inline F8 repeated(F4 a) {
  return {a, a};
}

/// Four lanes turned by R, then by one more.
template <int R>
inline F8 rotations(F4 a) {
  return {rotate<R>(a), rotate<R + 1>(a)};
}

/// The most lanes that are worked on at once.
using Wide = F8;
using WideMask = M8;
