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
// products lose less than 2^-147, bounds themselves less than 2^-145: 2^-140 is added to each.
// Overflow leaves a bound infinite, which nothing exceeds.
//
// Tips. A facet turns about the corner that is alone on its side, so it must not be sure that all
// corners are on one side unless the planes part them as directions too. Those need more than the
// margin, 5 e |n_b| < 30.1 e L_b^2, and the greatest n_b.g, which is 0 but for rounding: n_b's own
// 12 u L_b^3, the product's 18 u L_b^3, with u L_b <= e / 4, and 2^-146 for underflow. Together
// that is below 38 e L_b^2 + 2^-140 + 2^-146: sides are sure only above 50 e l_b T + 2^-139.

using Vectors = Coordinates<Wide>;

inline constexpr float kLeastProduct = 0x1p-140F;
inline constexpr float kLeastSide = 0x1p-139F;
inline constexpr std::size_t kWide = sizeof(Wide) / sizeof(float);

inline Vectors cross(const Vectors& a, const Vectors& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vectors minus(const Vectors& a, const Vectors& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vectors select(WideMask where, const Vectors& a, const Vectors& b) {
  return {select(where, a[0], b[0]), select(where, a[1], b[1]), select(where, a[2], b[2])};
}

inline Wide sum_of_magnitudes(const Vectors& v) {
  return (abs(v[0]) + abs(v[1])) + abs(v[2]);
}

inline Wide largest(const Vectors& v) {
  return greatest(abs(v[0]), abs(v[1]), abs(v[2]));
}

/// One triangle in each lane: corners, edges from the first one, and their product.
struct Facet {
  Facet(const float* slots, const std::uint32_t* at) {
    for (std::size_t row = 0; row < 9; ++row) {
      corner[row / 3][row % 3] = Wide::gather(slots + TriangleBlock::kWidth * row, at);
    }
    edge = {minus(corner[1], corner[0]), minus(corner[2], corner[0])};
    normal = cross(edge[0], edge[1]);
    longest = max(largest(edge[0]), largest(edge[1]));
  }

  std::array<Vectors, 3> corner;
  std::array<Vectors, 2> edge;
  Vectors normal;
  Wide longest;
};

/// A facet turned so that its tip, alone on its side of the other's plane, comes first.
struct OrientedFacet {
  Vectors tip;
  Vectors left;
  Vectors right;
};

/// Sides of a facet's corners beside another facet's plane.
struct Sides {
  Sides(const std::array<Wide, 3>& det, Wide bound) {
    const Wide below = Wide(0.0F) - bound;
    for (std::size_t i = 0; i < 3; ++i) {
      above[i] = det[i] > bound;
      certain[i] = above[i] | (below > det[i]);
    }
    most_above = (above[0] & above[1]) | (above[2] & (above[0] | above[1]));
  }

  [[nodiscard]] std::uint32_t all_certain() const {
    return bits(certain[0] & certain[1] & certain[2]);
  }

  [[nodiscard]] OrientedFacet turn(const Facet& f) const {
    const WideMask second = above[1] ^ most_above;
    const WideMask third = above[2] ^ most_above;
    const auto& [a, b, c] = f.corner;
    return {select(second, b, select(third, c, a)), select(second, c, select(third, a, b)),
            select(second, a, select(third, b, c))};
  }

  std::array<WideMask, 3> above;
  std::array<WideMask, 3> certain;
  WideMask most_above;
};

/// Determinants of a facet's corners against a plane, and the plane's own corners but the first.
struct Heights {
  Heights(const Vectors& normal, Wide first, const Facet& facet, const Facet& own)
      : of{first, first + dot<Wide>(normal, facet.edge[0]),
           first + dot<Wide>(normal, facet.edge[1])} {
    const Wide a = dot<Wide>(normal, own.edge[0]);
    const Wide b = dot<Wide>(normal, own.edge[1]);
    const Wide zero(0.0F);
    lower = least(zero, a, b);
    upper = greatest(zero, a, b);
  }

  /// The plane's normal parts the facets.
  [[nodiscard]] WideMask apart(Wide margin) const {
    return (least(of[0], of[1], of[2]) > upper + margin) |
           (lower > greatest(of[0], of[1], of[2]) + margin);
  }

  std::array<Wide, 3> of;
  Wide lower;
  Wide upper;
};

inline Wide direction_margin(Wide error, const Vectors& n) {
  return Wide(5.0F) * error * sum_of_magnitudes(n) + Wide(kLeastProduct);
}

/// Sign of `edge.m` where it is certain: lanes in which it is above, and below.
struct Turning {
  Turning(const Vectors& edge, const Vectors& m, Wide error, Wide bound) {
    const Wide det = dot<Wide>(edge, m);
    const Wide limit = Wide(4.0F) * error * sum_of_magnitudes(m) + bound;
    above = bits(det > limit);
    below = bits(Wide(0.0F) - limit > det);
  }

  std::uint32_t above;
  std::uint32_t below;
};

/// Judges kWide pairs.
inline Verdicts judge_wide(const float* slots, const std::uint32_t* first,
                           const std::uint32_t* second) {
  const Facet a(slots, first);
  const Facet b(slots, second);
  const Wide error = Wide::gather(slots + TriangleBlock::kWidth * TriangleSlot::kErrorRow, first);
  const Vectors w = minus(a.corner[0], b.corner[0]);
  const Heights on_b(b.normal, dot<Wide>(b.normal, w), a, b);
  const Heights on_a(a.normal, Wide(0.0F) - dot<Wide>(a.normal, w), b, a);
  const std::uint32_t apart = bits(on_b.apart(direction_margin(error, b.normal)) |
                                   on_a.apart(direction_margin(error, a.normal)));
  constexpr std::uint32_t kAll = (1U << kWide) - 1;
  if (apart == kAll) {
    return {0, 0};
  }
  const Wide length_a = a.longest + Wide(2.0F) * error;
  const Wide length_b = b.longest + Wide(2.0F) * error;
  const Wide lever = error * ((largest(w) + length_a) + length_b);
  const Wide least_side(kLeastSide);
  const Sides sides_a(on_b.of, Wide(50.0F) * lever * length_b + least_side);
  const Sides sides_b(on_a.of, Wide(50.0F) * lever * length_a + least_side);
  const OrientedFacet p = sides_a.turn(a);
  const OrientedFacet q = sides_b.turn(b);
  // Guigue and Devillers: with both tips above, the intervals on the planes' common line meet if
  // left.m >= 0 and right.m <= 0. A tip below turns the other facet over.
  const WideMask flipped = sides_a.most_above ^ sides_b.most_above;
  const Vectors between = minus(q.tip, p.tip);
  const Vectors left = cross(minus(select(flipped, q.right, q.left), q.tip), between);
  const Vectors right = cross(minus(select(flipped, q.left, q.right), q.tip), between);
  const Wide bound = Wide(65.0F) * lever * length_a + Wide(kLeastProduct);
  const Turning at_left(minus(p.left, p.tip), left, error, bound);
  const Turning at_right(minus(p.right, p.tip), right, error, bound);
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
    const Verdicts some = judge_wide(floats, first + begin, second + begin);
    all.hit |= some.hit << begin;
    all.open |= some.open << begin;
  }
  const std::uint32_t wanted = (1U << count) - 1;
  return {all.hit & wanted, all.open & wanted};
}
