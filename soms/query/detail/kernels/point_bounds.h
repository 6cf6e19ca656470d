// Lower bounds of the distances of a point from boxes and triangles. Included after
// triangle_pairs.h, once for each instruction set. near/point_pose.h proves them, and what
// products, squares and quotients that underflow lose.

inline constexpr float kPointMargin = 0x1p-18F;  // of a gap of a box, for each unit of S
inline constexpr float kPointError = 0x1p-20F;   // of a corner, likewise
inline constexpr float kPointShrink = 1 - 0x1p-19F;

/// S of the proof.
inline float sum_of_sizes(const std::array<float, 3>& d, float l1_radius) {
  return ((std::abs(d[0]) + std::abs(d[1])) + std::abs(d[2])) + l1_radius;
}

inline void bound_boxes(const PointNumbers& point, const WideNode& node, PointNodeKeys& keys) {
  const std::array<float, 3> d = point.offset(node.origin);
  std::array<float, 3> q = d;
  if (node.oriented != 0) {
    for (std::size_t j = 0; j < 3; ++j) {
      q[j] = (node.row[0][j] * d[0] + node.row[1][j] * d[1]) + node.row[2][j] * d[2];
    }
  }
  const F4 margin(sum_of_sizes(d, node.l1_radius) * kPointMargin + point.slack);
  F4 most(0.0F);
  F4 square(0.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    const F4 gap =
        (abs(F4::load(node.center[i].data()) - F4(q[i])) - F4::load(node.half[i].data())) - margin;
    const F4 beyond = max(gap, F4(0.0F));
    most = i == 0 ? gap : max(most, gap);
    square = square + beyond * beyond;
  }
  select(most > F4(0.0F), sqrt(square) * F4(kPointShrink), most).store(keys.key.data());
}

/// The shortest line so far from the point to each triangle.
struct PointLine {
  void take(M8 where, F8 length_squared, const Three& v) {
    square = select(where, length_squared, square);
    for (std::size_t i = 0; i < 3; ++i) {
      line[i] = select(where, v[i], line[i]);
    }
  }

  F8 square = F8(0x1p120F);
  Three line = {F8(0.0F), F8(0.0F), F8(0.0F)};
};

inline Three minus8(const Three& a, const Three& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Three cross8(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The lines from the point, which is the origin, to edges and faces (Ericson 2004, 5.1.5).
inline PointLine shortest_lines(const Corners& v) {
  const F8 tiny(0x1p-100F);
  PointLine best;
  const Three normal = cross8(minus8(v[1], v[0]), minus8(v[2], v[0]));
  F8 inside(0.0F);
  for (std::size_t i = 0; i < 3; ++i) {
    const Three& from = v[i];
    const Three edge = minus8(v[(i + 1) % 3], from);
    const F8 share = min(
        max((F8(0.0F) - dot<F8>(from, edge)) / max(dot<F8>(edge, edge), tiny), F8(0.0F)), F8(1.0F));
    const Three line = {from[0] + share * edge[0], from[1] + share * edge[1],
                        from[2] + share * edge[2]};
    const F8 square = dot<F8>(line, line);
    best.take(best.square > square, square, line);
    const F8 here = F8(0.0F) - dot<F8>(from, cross8(normal, edge));
    inside = i == 0 ? here : min(inside, here);
  }
  const F8 height = dot<F8>(v[0], normal);
  const F8 share = height / max(dot<F8>(normal, normal), tiny);
  const F8 square = height * share;
  best.take((best.square > square) & (inside > F8(0.0F)), square,
            {share * normal[0], share * normal[1], share * normal[2]});
  return best;
}

inline void bound_triangles(const PointNumbers& point, const TriangleBlock& block,
                            PointBlockKeys& keys) {
  const std::array<float, 3> d = point.offset(block.origin);
  const Three from = splat(d);
  Corners v = corners_of(block);
  for (Three& corner : v) {
    corner = minus8(corner, from);
  }
  const PointLine best = shortest_lines(v);
  const Three& n = best.line;
  const F8 error(sum_of_sizes(d, block.l1_radius) * kPointError + point.slack);
  const F8 size = (abs(n[0]) + abs(n[1])) + abs(n[2]);
  const F8 gap = (least(dot<F8>(n, v[0]), dot<F8>(n, v[1]), dot<F8>(n, v[2])) - size * error) -
                 F8(kLeastProduct);
  const F8 length = sqrt(dot<F8>(n, n));
  (gap / max(length, F8(0x1p-60F)) * F8(kPointShrink)).store(keys.key.data());
  sqrt(best.square).store(keys.estimate.data());
}
