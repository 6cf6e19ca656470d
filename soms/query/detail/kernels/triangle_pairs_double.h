// Judges in double, for any kind of lanes WideDouble, what floats leave open. Included after
// triangle_pairs.h and lanes_double.h, once for each instruction set.
//
// Most pairs that floats leave open are a small triangle and a far larger one: their margin is
// that of the large one's size. Here corners are moved in double, from the floats of the blocks, so
// that each triangle has an error of its own, and that of the small one is small.
//
// Why a verdict is sure. As in triangle_pairs.h a moved and rounded corner stands at a* or b*, W is
// what the maps are off by, together or each alone, and S = radius_x + radius_y + |d|_1. A block's
// float is off by 2^-24 of the corner's coordinate, so a corner of x, turned, by at most 2^-24 (1 +
// 1e-5) radius_x on an axis, one of y by 2^-24 radius_y. Products, sums and the offset's last
// rounding in double add less than 8 u64 S (u64 = 2^-53). So
//   e_a = 1.05 * 2^-24 radius_x + W + 2^-48 S,   e_b = 1.05 * 2^-24 radius_y + W + 2^-48 S
// bound |a - a*| and |b - b*|. Let E = e_a + e_b. No coordinate exceeds S, and u64 S is at most e_a
// / 32 and e_b / 32: whatever is rounded below is relative to differences of at most 2 S.
//
// f, g are the edges of a and b from their first corners, w = a0 - b0; L_a, L_b, M their largest
// coordinates, l_a = L_a + 4 e_a, l_b = L_b + 4 e_b, T = M + l_a + l_b. Then f is off f* by 2.07
// e_a, g by 2.07 e_b, w by 1.04 E; the largest coordinates of f*, g* and of any difference of
// corners a* - b* are below l_a, l_b and T.
//
// Planes, as directions. w + f_i - g_j is off a*_i - b*_j by 1.1 E. Products and sums along n take
// 6 u64 * 6 S |n|_1 <= 0.6 E |n|_1: below 2 E |n|_1 in all.
//
// Planes, as sides. n_b is off by 8.6 e_b l_b on an axis: two products, each off by 4.14 e_b l_b,
// and roundings of 4.1 u64 L_b^2. The determinant of a corner of a is off by 1.07 E |n_b|_1 for w +
// f_i, by 0.32 E |n_b|_1 for products and sums and by 3 * 8.6 e_b l_b T for the normal: below 1.4 E
// |n_b|_1 + 26 e_b l_b T. With tips (triangle_pairs.h) it must exceed the margin of directions and
// the greatest n_b.g, which is at most 31 u64 L_b^3 <= 2 e_b L_b^2: 2.5 E |n_b|_1 + 27 e_b l_b T is
// more than either.
//
// Edges. p is an edge of a, q one of b, with |p*| <= 2 l_a and |q| <= 2 l_b, and m = q x W with W
// the difference of the tips, |W*| <= T. m is off by 2 (2 l_b 1.04 E + T 2.07 e_b) and roundings of
// 8.2 u64 l_b T <= 0.6 e_b T: below 4.2 l_b E + 4.8 e_b T. p.m is off by 3 * 2 l_a times that, by
// 2.07 e_a |m|_1 for p and by 0.4 e_a |m|_1 for products and sums: below l_a (26 l_b E + 29 e_b T)
// + 2.5 e_a |m|_1.
//
// Nothing underflows that matters: e_a and e_b are at least 2^-101, as W is (relative_pose.h), so
// bounds are above 2^-300 or, times |n|_1 alone, beside one of those, and products lose below
// 2^-900. A direction n all of whose products underflow has the heights 0 and parts nothing. Floats
// that `ratio` makes subnormal lose 2^-150, which W's 2^-100 covers. Nothing overflows either: W is
// below 2^100.

using Doubles = Coordinates<WideDouble>;

/// Bounds of the proof above.
class DoubleBounds {
 public:
  DoubleBounds(const FacetOf<WideDouble>& a, const FacetOf<WideDouble>& b,
               const WideDouble& error_a, const WideDouble& error_b)
      : error_a_(error_a),
        error_b_(error_b),
        both_(error_a + error_b),
        length_a_(a.longest + WideDouble(4.0) * error_a),
        length_b_(b.longest + WideDouble(4.0) * error_b) {}

  [[nodiscard]] WideDouble direction(const Doubles& n) const {
    return WideDouble(2.0) * both_ * sum_of_magnitudes(n);
  }

  void set_distance(const Doubles& w) {
    const WideDouble distance = (largest(w) + length_a_) + length_b_;
    side_a_ = WideDouble(27.0) * error_b_ * length_b_ * distance;
    side_b_ = WideDouble(27.0) * error_a_ * length_a_ * distance;
    edges_ =
        length_a_ * (WideDouble(26.0) * length_b_ * both_ + WideDouble(29.0) * error_b_ * distance);
  }

  [[nodiscard]] WideDouble sides_of_a(const Doubles& normal_b) const {
    return WideDouble(2.5) * both_ * sum_of_magnitudes(normal_b) + side_a_;
  }

  [[nodiscard]] WideDouble sides_of_b(const Doubles& normal_a) const {
    return WideDouble(2.5) * both_ * sum_of_magnitudes(normal_a) + side_b_;
  }

  [[nodiscard]] WideDouble edges(const Doubles& m) const {
    return WideDouble(2.5) * error_a_ * sum_of_magnitudes(m) + edges_;
  }

 private:
  WideDouble error_a_;
  WideDouble error_b_;
  WideDouble both_;
  WideDouble length_a_;
  WideDouble length_b_;
  WideDouble side_a_;
  WideDouble side_b_;
  WideDouble edges_;
};

/// Some pairs of lanes, gathered for kDoubles pairs at once.
struct GatheredPairs {
  using Row = std::array<double, kDoubles>;

  alignas(64) std::array<Row, 9> x;  ///< corners as in the block
  alignas(64) std::array<Row, 9> y;
  alignas(64) std::array<Row, 3> offset;
  alignas(64) Row error_x;
  alignas(64) Row error_y;

  void put(std::size_t at, const TriangleSlot& slot, std::size_t lane_x, std::size_t lane_y) {
    for (std::size_t row = 0; row < 9; ++row) {
      x[row][at] = slot.own[row][lane_x];
      y[row][at] = slot.y[row][lane_y];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      offset[i][at] = slot.offset[i];
    }
    error_x[at] = slot.error_x;
    error_y[at] = slot.error_y;
  }

  /// The triangles of x, moved.
  [[nodiscard]] FacetOf<WideDouble> moved_x(const PoseNumbers& pose) const {
    std::array<Doubles, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const Doubles v = {WideDouble::load(x[3 * k]), WideDouble::load(x[3 * k + 1]),
                         WideDouble::load(x[3 * k + 2])};
      for (std::size_t i = 0; i < 3; ++i) {
        const Doubles n = {WideDouble(pose.column[0][i]), WideDouble(pose.column[1][i]),
                           WideDouble(pose.column[2][i])};
        corner[k][i] = dot<WideDouble>(n, v) + WideDouble::load(offset[i]);
      }
    }
    return FacetOf<WideDouble>(corner);
  }

  [[nodiscard]] FacetOf<WideDouble> facet_y() const {
    std::array<Doubles, 3> corner;
    for (std::size_t row = 0; row < 9; ++row) {
      corner[row / 3][row % 3] = WideDouble::load(y[row]);
    }
    return FacetOf<WideDouble>(corner);
  }
};

inline Verdicts judge_in_double(const TriangleSlot* slots, const PoseNumbers& pose,
                                const std::uint16_t* pairs, std::size_t count) {
  Verdicts all{0, 0};
  GatheredPairs gathered;
  for (std::size_t begin = 0; begin < count; begin += kDoubles) {
    for (std::size_t k = 0; k < kDoubles; ++k) {
      const std::uint32_t pair = pairs[std::min(begin + k, count - 1)];
      gathered.put(k, slots[pair >> 6], pair >> 3 & 7, pair & 7);
    }
    const FacetOf<WideDouble> a = gathered.moved_x(pose);
    const FacetOf<WideDouble> b = gathered.facet_y();
    const Verdicts some = judge_facets<kDoubles>(
        a, b,
        DoubleBounds(a, b, WideDouble::load(gathered.error_x), WideDouble::load(gathered.error_y)));
    all.hit |= some.hit << begin;
    all.open |= some.open << begin;
  }
  const std::uint32_t wanted = (1U << count) - 1;
  return {all.hit & wanted, all.open & wanted};
}
