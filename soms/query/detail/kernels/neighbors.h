// Triangles with corners in common, kDoubles pairs at a time: do they share nothing else? Included
// inside a namespace, after relative_poses.h.
//
// A linear function that is 0 on what two triangles have in common, above 0 at what else one of
// them has and below 0 at what else the other has has no other zero on either: they share nothing
// else. Any function will do, whatever it was computed from; only its values need bounds. With
// u = 2^-53, and differences of corners as computed, each off by u of itself (what underflows in a
// difference is exact):
//
// One corner v. f(x) = n (x - v), for any doubles n. Three products of factors that are off by u,
// and two sums: the error is at most 4.01 u sum |n_i| |x_i - v_i|; that sum is computed to 4.01 u
// of itself. Each product that underflows adds 2^-1075. kOfCorner is 8 u, kOfUnderflow 2^-1070.
//
// Two corners u and v, e = v - u. f(x) = m ((x - u) x e), for any doubles m: linear in x, and 0 on
// the whole line through u and v. A product of two differences is off by 3.01 u of itself, the
// difference of two products by u more, its product with m_i by u more, two sums by 2 u more: at
// most 7.1 u sum |m_i| (|a_j e_k| + |a_k e_j|), and that sum is computed to 8 u of itself. kOfEdge
// is 12 u. Two products that underflow add 2^-1074 to a component, times |m_i|: kOfProducts in
// place of them, 2^-1000, adds more than 2^-1050 |m_i|. Three last products add less than 2^-1070.
//
// Where something overflows or is 0 throughout, no comparison holds, and exact signs decide.

inline Real weight(const std::array<Real, 3>& a) {
  return (abs(a[0]) + abs(a[1])) + abs(a[2]);
}

inline Real product(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

inline Real product_of_sizes(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
  return (abs(a[0]) * abs(b[0]) + abs(a[1]) * abs(b[1])) + abs(a[2]) * abs(b[2]);
}

/// From the first direction to the second, each weighed by the other's size.
inline std::array<Real, 3> weighed(const std::array<Real, 3>& a, const std::array<Real, 3>& b,
                                   const Real& sign) {
  const Real of_a = weight(b);
  const Real of_b = sign * weight(a);
  return {a[0] * of_a + b[0] * of_b, a[1] * of_a + b[1] * of_b, a[2] * of_a + b[2] * of_b};
}

inline Real from_row(const NeighborLanes::Row& row, std::size_t first) {
  Real a;
  std::memcpy(&a.v, row.data() + first, sizeof a.v);
  return a;
}

/// Corner `to` of the lanes from `first` on, as seen from corner 0.
inline std::array<Real, 3> seen_from_first(const NeighborLanes& lanes, std::size_t to,
                                           std::size_t first) {
  std::array<Real, 3> seen;
  for (std::size_t i = 0; i < 3; ++i) {
    seen[i] = from_row(lanes.corner[3 * to + i], first) - from_row(lanes.corner[i], first);
  }
  return seen;
}

inline std::uint32_t apart_at_corner(const NeighborLanes& lanes) {
  constexpr double kOfCorner = 8 * 0x1p-53;
  constexpr double kOfUnderflow = 0x1p-1070;
  std::uint32_t apart = 0;
  for (std::size_t first = 0; first < NeighborLanes::kMost; first += kDoubles) {
    std::array<std::array<Real, 3>, 4> d;
    for (std::size_t k = 0; k < 4; ++k) {
      d[k] = seen_from_first(lanes, k + 1, first);
    }
    const std::array<Real, 3> n =
        weighed(weighed(d[0], d[1], Real(1)), weighed(d[2], d[3], Real(1)), Real(-1));
    std::array<Flag, 4> sure;
    for (std::size_t k = 0; k < 4; ++k) {
      const Real value = product(n, d[k]);
      const Real bound = product_of_sizes(n, d[k]) * Real(kOfCorner) + Real(kOfUnderflow);
      sure[k] = (k < 2 ? value : Real(0) - value) > bound;
    }
    apart |= bits((sure[0] & sure[1]) & (sure[2] & sure[3])) << first;
  }
  return apart;
}

/// A cross product, and the sums of its products' sizes.
struct TurnedSide {
  std::array<Real, 3> cross;
  std::array<Real, 3> sums;

  TurnedSide(const std::array<Real, 3>& a, const std::array<Real, 3>& e) {
    constexpr double kOfProducts = 0x1p-1000;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real plus = a[(i + 1) % 3] * e[(i + 2) % 3];
      const Real minus = a[(i + 2) % 3] * e[(i + 1) % 3];
      cross[i] = plus - minus;
      sums[i] = (abs(plus) + abs(minus)) + Real(kOfProducts);
    }
  }
};

inline std::uint32_t apart_at_edge(const NeighborLanes& lanes) {
  constexpr double kOfEdge = 12 * 0x1p-53;
  constexpr double kOfUnderflow = 0x1p-1070;
  std::uint32_t apart = 0;
  for (std::size_t first = 0; first < NeighborLanes::kMost; first += kDoubles) {
    const std::array<Real, 3> e = seen_from_first(lanes, 1, first);
    const TurnedSide p(seen_from_first(lanes, 2, first), e);
    const TurnedSide r(seen_from_first(lanes, 3, first), e);
    const std::array<Real, 3> m = weighed(p.cross, r.cross, Real(-1));
    const Flag above =
        product(m, p.cross) > product_of_sizes(m, p.sums) * Real(kOfEdge) + Real(kOfUnderflow);
    const Flag below = Real(0) - product(m, r.cross) >
                       product_of_sizes(m, r.sums) * Real(kOfEdge) + Real(kOfUnderflow);
    apart |= bits(above & below) << first;
  }
  return apart;
}
