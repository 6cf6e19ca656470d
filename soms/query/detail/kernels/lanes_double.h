// kDoubles lanes of doubles, in the compilers' own vector types. Included inside a namespace, after
// kDoubles, once for each instruction set; see triangle_pairs.h.

struct MaskDouble {
  using Lanes [[gnu::vector_size(8 * kDoubles)]] = std::int64_t;

  Lanes v;
};

inline MaskDouble operator|(const MaskDouble& a, const MaskDouble& b) {
  return {a.v | b.v};
}

inline MaskDouble operator&(const MaskDouble& a, const MaskDouble& b) {
  return {a.v & b.v};
}

inline MaskDouble operator^(const MaskDouble& a, const MaskDouble& b) {
  return {a.v ^ b.v};
}

inline std::uint32_t bits(const MaskDouble& m) {
  std::uint32_t set = 0;
  for (std::size_t k = 0; k < kDoubles; ++k) {
    set |= static_cast<std::uint32_t>(m.v[k] & 1) << k;
  }
  return set;
}

struct WideDouble {
  using Lanes [[gnu::vector_size(8 * kDoubles)]] = double;

  WideDouble() = default;

  explicit WideDouble(const Lanes& x) : v(x) {}

  explicit WideDouble(double x) : v(x - Lanes{}) {}

  static WideDouble load(const std::array<double, kDoubles>& from) {
    WideDouble a;
    std::memcpy(&a.v, from.data(), sizeof a.v);
    return a;
  }

  Lanes v;
};

inline WideDouble operator+(const WideDouble& a, const WideDouble& b) {
  return WideDouble(a.v + b.v);
}

inline WideDouble operator-(const WideDouble& a, const WideDouble& b) {
  return WideDouble(a.v - b.v);
}

inline WideDouble operator*(const WideDouble& a, const WideDouble& b) {
  return WideDouble(a.v * b.v);
}

inline MaskDouble operator>(const WideDouble& a, const WideDouble& b) {
  return {a.v > b.v};
}

inline WideDouble select(const MaskDouble& where, const WideDouble& a, const WideDouble& b) {
  return WideDouble(where.v ? a.v : b.v);
}

inline WideDouble min(const WideDouble& a, const WideDouble& b) {
  return WideDouble(a.v < b.v ? a.v : b.v);
}

inline WideDouble max(const WideDouble& a, const WideDouble& b) {
  return WideDouble(a.v > b.v ? a.v : b.v);
}

inline WideDouble abs(const WideDouble& a) {
  MaskDouble::Lanes magnitude;
  std::memcpy(&magnitude, &a.v, sizeof magnitude);
  magnitude &= std::numeric_limits<std::int64_t>::max();
  WideDouble b;
  std::memcpy(&b.v, &magnitude, sizeof magnitude);
  return b;
}
