// Judges pairs of triangles in float, for any kind of lanes Wide. Included after triangles.h, once
// for each instruction set.
//
// Why a verdict is sure. Let X be the inverse rotation of relative_pose.h; as a map of space it
// keeps orientations, X's determinant being about 1. So do shifts and the layout's unit. Seen
// through these, a moved and rounded corner stands at a place a*, and the slot holds a float a.
// By relative_pose.h the map of x's corners and that of y's together are off by W on an axis, which
// is half of `slack`. In units of u = 2^-24 times S = radius_x + radius_y + |d|_1, corners of x
// moved in float are off by 6.1 (rounded rotation, rounded corner, product and two sums 5, offset
// and last sum 2, no coordinate of more than one of them being S), corners of y by 1: so
//   e = 8 u S + slack / 2
// bounds |a - a*| for each corner, and the sum of both errors for corners of different triangles.
// No coordinate of the slot exceeds S, so rounding a difference of corners of different triangles
// adds 0.13 e at most and one of the same triangle 0.26 e: 1.13 e and 2.26 e in all.
//
// Below, f1, f2 are the edges of triangle a from its first corner and n_a their product; g1, g2 and
// n_b those of b; w = a0 - b0. L_a, L_b, M are the largest coordinates of f, g, w; |.| of a vector
// is the sum of magnitudes. l_a = L_a + 2 e, l_b likewise, T = M + l_a + l_b.
//
// Planes, as directions. n_b as it was computed parts the triangles if n_b.(a_i - b_j) > 0 for all
// i, j. Its value is w + f_i - g_j along n_b, of which corners are off by e, differences by 0.65 e,
// products and sums by 2.7 e: below 5 e |n_b|. Nothing is claimed of n_b itself.
//
// Planes, as sides. n_b is off by 10.3 e (L_b + e) on an axis: edges 9.04 e L_b + 10.3 e^2,
// products 1.05 e L_b. The determinant of a corner of a is off by 3 e |n_b| for corners,
// differences, products and sums, and 3 * 10.3 e (L_b + e) (M + L_a + 1.4 e) for the normal. With
// |n_b| <= 6.01 L_b^2 both are below 50 e l_b T.
//
// Edges. With all sides certain, let p be an edge of a from its tip, q one of b, W the difference
// of the tips. m = q x W is off by 2 (1.2 e |q| + 2.26 e |W| + 2.8 e^2) + 1.05 e |W| on an axis,
// with |q| <= 2 L_b and |W| <= M + L_a + L_b the largest coordinates: below 10.7 e T. p.m is off
// by 2.26 e |m| for p, 0.8 e |m| for products and sums and 3 * 10.7 e T (2 L_a + 2.26 e): below e
// (4 |m| + 65 l_a T). It pays to have the smaller triangle for a.
//
// Underflow. No product of two lengths loses more than 2^-147. Times T this is below 2^-140 where
// T < 1; else e >= 2^-23 T, as T <= 4 S + 8 e, and the rest of the bounds covers it. The last
// products lose less than 2^-147. Of the bounds, e T loses 2^-150, which is then multiplied by at
// most 65 lengths: below 2^-143 where T < 1; where it is not, nothing in them underflows, as both e
// and lengths exceed 2^-23. So 2^-140 is added to each: it covers even triangles whose products are
// all 0, which stay open. Overflow leaves a bound infinite, which nothing exceeds; no bound is 0
// times infinity, as lengths exceed e and e is finite.
//
// Tips. A facet turns about the corner that is alone on its side, so it must not be sure that all
// corners are on one side unless the planes part them as directions too. Those need more than the
// margin, 5 e |n_b| < 30.1 e L_b^2, and the greatest n_b.g, which is 0 but for rounding: n_b's own
// 12 u L_b^3, the product's 18 u L_b^3, with u L_b <= e / 4, and 2^-146 for underflow, and bounds
// lose 2^-143. Together that is below 38 e L_b^2 + 2^-140 + 2^-142: sides are sure only above 50 e
// l_b T + 2^-139.

using Vectors = Coordinates<Wide>;

inline constexpr float kLeastProduct = 0x1p-140F;
inline constexpr float kLeastSide = 0x1p-139F;
inline constexpr std::size_t kWide = sizeof(Wide) / sizeof(float);

template <class F>
inline Coordinates<F> cross(const Coordinates<F>& a, const Coordinates<F>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class F>
inline Coordinates<F> minus(const Coordinates<F>& a, const Coordinates<F>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Mask, class F>
inline Coordinates<F> select(const Mask& where, const Coordinates<F>& a, const Coordinates<F>& b) {
  return {select(where, a[0], b[0]), select(where, a[1], b[1]), select(where, a[2], b[2])};
}

template <class F>
inline F sum_of_magnitudes(const Coordinates<F>& v) {
  return (abs(v[0]) + abs(v[1])) + abs(v[2]);
}

template <class F>
inline F largest(const Coordinates<F>& v) {
  return greatest(abs(v[0]), abs(v[1]), abs(v[2]));
}

/// One triangle in each lane: corners, edges from the first one, and their product.
template <class F>
struct FacetOf {
  explicit FacetOf(const std::array<Coordinates<F>, 3>& corners)
      : corner(corners),
        edge{minus(corner[1], corner[0]), minus(corner[2], corner[0])},
        normal(cross(edge[0], edge[1])),
        longest(max(largest(edge[0]), largest(edge[1]))) {}

  std::array<Coordinates<F>, 3> corner;
  std::array<Coordinates<F>, 2> edge;
  Coordinates<F> normal;
  F longest;
};

using Facet = FacetOf<Wide>;

inline Facet facet_at(const float* slots, const std::uint32_t* at) {
  std::array<Vectors, 3> corner;
  for (std::size_t row = 0; row < 9; ++row) {
    corner[row / 3][row % 3] = Wide::gather(slots + TriangleBlock::kWidth * row, at);
  }
  return Facet(corner);
}

/// A facet turned so that its tip, alone on its side of the other's plane, comes first.
template <class F>
struct OrientedFacet {
  Coordinates<F> tip;
  Coordinates<F> left;
  Coordinates<F> right;
};

/// Sides of a facet's corners beside another facet's plane.
template <class F>
struct Sides {
  using Mask = decltype(F() > F());

  Sides(const std::array<F, 3>& det, const F& bound) {
    const F below = F(0.0F) - bound;
    for (std::size_t i = 0; i < 3; ++i) {
      above[i] = det[i] > bound;
      certain[i] = above[i] | (below > det[i]);
    }
    most_above = (above[0] & above[1]) | (above[2] & (above[0] | above[1]));
  }

  [[nodiscard]] std::uint32_t all_certain() const {
    return bits(certain[0] & certain[1] & certain[2]);
  }

  [[nodiscard]] OrientedFacet<F> turn(const FacetOf<F>& f) const {
    const Mask second = above[1] ^ most_above;
    const Mask third = above[2] ^ most_above;
    const auto& [a, b, c] = f.corner;
    return {select(second, b, select(third, c, a)), select(second, c, select(third, a, b)),
            select(second, a, select(third, b, c))};
  }

  std::array<Mask, 3> above;
  std::array<Mask, 3> certain;
  Mask most_above;
};

/// Determinants of a facet's corners against a plane, and the plane's own corners but the first.
template <class F>
struct Heights {
  Heights(const Coordinates<F>& normal, const F& first, const FacetOf<F>& facet,
          const FacetOf<F>& own)
      : of{first, first + dot<F>(normal, facet.edge[0]), first + dot<F>(normal, facet.edge[1])} {
    const F a = dot<F>(normal, own.edge[0]);
    const F b = dot<F>(normal, own.edge[1]);
    const F zero(0.0F);
    lower = least(zero, a, b);
    upper = greatest(zero, a, b);
  }

  /// The plane's normal parts the facets.
  [[nodiscard]] auto apart(const F& margin) const {
    return (least(of[0], of[1], of[2]) > upper + margin) |
           (lower > greatest(of[0], of[1], of[2]) + margin);
  }

  std::array<F, 3> of;
  F lower;
  F upper;
};

/// Sign of `edge.m` where it is certain: lanes in which it is above, and below.
struct Turning {
  template <class F>
  Turning(const Coordinates<F>& edge, const Coordinates<F>& m, const F& limit) {
    const F det = dot<F>(edge, m);
    above = bits(det > limit);
    below = bits(F(0.0F) - limit > det);
  }

  std::uint32_t above;
  std::uint32_t below;
};

/// Bounds of the proof above, for facets a and b and w = a0 - b0.
class FloatBounds {
 public:
  FloatBounds(const Facet& a, const Facet& b, Wide error)
      : error_(error),
        length_a_(a.longest + Wide(2.0F) * error),
        length_b_(b.longest + Wide(2.0F) * error) {}

  [[nodiscard]] Wide direction(const Vectors& n) const {
    return Wide(5.0F) * error_ * sum_of_magnitudes(n) + Wide(kLeastProduct);
  }

  /// For what depends on w. Called once, unless all lanes are apart.
  void set_distance(const Vectors& w) {
    lever_ = error_ * ((largest(w) + length_a_) + length_b_);
    edges_ = Wide(65.0F) * lever_ * length_a_ + Wide(kLeastProduct);
  }

  /// Of the corners of a beside the plane of b.
  [[nodiscard]] Wide sides_of_a(const Vectors& /*normal of b*/) const {
    return Wide(50.0F) * lever_ * length_b_ + Wide(kLeastSide);
  }

  [[nodiscard]] Wide sides_of_b(const Vectors& /*normal of a*/) const {
    return Wide(50.0F) * lever_ * length_a_ + Wide(kLeastSide);
  }

  /// Of an edge of a times m.
  [[nodiscard]] Wide edges(const Vectors& m) const {
    return Wide(4.0F) * error_ * sum_of_magnitudes(m) + edges_;
  }

 private:
  Wide error_;
  Wide length_a_;
  Wide length_b_;
  Wide lever_;
  Wide edges_;
};

/// Judges a pair in each of `kCount` lanes.
template <std::size_t kCount, class F, class Bounds>
inline Verdicts judge_facets(const FacetOf<F>& a, const FacetOf<F>& b, Bounds bounds) {
  const Coordinates<F> w = minus(a.corner[0], b.corner[0]);
  const Heights<F> on_b(b.normal, dot<F>(b.normal, w), a, b);
  const Heights<F> on_a(a.normal, F(0.0F) - dot<F>(a.normal, w), b, a);
  const std::uint32_t apart =
      bits(on_b.apart(bounds.direction(b.normal)) | on_a.apart(bounds.direction(a.normal)));
  constexpr std::uint32_t kAll = (1U << kCount) - 1;
  if (apart == kAll) {
    return {0, 0};
  }
  bounds.set_distance(w);
  const Sides<F> sides_a(on_b.of, bounds.sides_of_a(b.normal));
  const Sides<F> sides_b(on_a.of, bounds.sides_of_b(a.normal));
  const OrientedFacet<F> p = sides_a.turn(a);
  const OrientedFacet<F> q = sides_b.turn(b);
  // Guigue and Devillers: with both tips above, the intervals on the planes' common line meet if
  // left.m >= 0 and right.m <= 0. A tip below turns the other facet over.
  const auto flipped = sides_a.most_above ^ sides_b.most_above;
  const Coordinates<F> between = minus(q.tip, p.tip);
  const Coordinates<F> left = cross(minus(select(flipped, q.right, q.left), q.tip), between);
  const Coordinates<F> right = cross(minus(select(flipped, q.left, q.right), q.tip), between);
  const Turning at_left(minus(p.left, p.tip), left, bounds.edges(left));
  const Turning at_right(minus(p.right, p.tip), right, bounds.edges(right));
  const std::uint32_t below = bits(sides_b.most_above);  // tips of b
  const std::uint32_t meets =
      (~below & at_left.above & at_right.below) | (below & at_left.below & at_right.above);
  const std::uint32_t misses =
      (~below & (at_left.below | at_right.above)) | (below & (at_left.above | at_right.below));
  const std::uint32_t sure = sides_a.all_certain() & sides_b.all_certain() & ~apart;
  return {sure & meets, kAll & ~apart & ~(sure & (meets | misses))};
}

inline Verdicts judge(const TriangleSlot* slots, const std::uint32_t* first,
                      const std::uint32_t* second, std::size_t count) {
  const auto* floats = reinterpret_cast<const float*>(slots);
  Verdicts all{0, 0};
  for (std::size_t begin = 0; begin < count; begin += kWide) {
    const Facet a = facet_at(floats, first + begin);
    const Facet b = facet_at(floats, second + begin);
    const Wide error =
        Wide::gather(floats + TriangleBlock::kWidth * TriangleSlot::kErrorRow, first + begin);
    const Verdicts some = judge_facets<kWide>(a, b, FloatBounds(a, b, error));
    all.hit |= some.hit << begin;
    all.open |= some.open << begin;
  }
  const std::uint32_t wanted = (1U << count) - 1;
  return {all.hit & wanted, all.open & wanted};
}
