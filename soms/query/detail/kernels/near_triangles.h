// Bounds the distances of pairs of triangles in float, for any kind of lanes Wide. Included after
// near_nodes.h, once for each instruction set.
//
// Any direction v proves a lower bound: the gap between the triangles along v over v's length. The
// slot's corners are off by e together (triangle_pairs.h). Along v, the products of a corner of
// each add 3.01 u |v|_1 S at most to that, u S being e / 8, and their difference u |v|_1 S: the gap
// is off by less than 2 e |v|_1. 2^-140 covers what underflows. The length is off by 2^-21 of it,
// the quotient by 2^-24: a factor of 1 - 2^-20. So it does not matter with what error v was
// computed, and v is the shortest line that floats find between the triangles. No answer needs that
// factor, nor the one of the squared reach below: e is at least 2^-21 of the distance.
//
// Underflow. Products of v and corners lose 2^-150 each, less than 2^-146 in all: 2^-140. The gap
// is divided by 2^-60 at least: longer |v| is rounded by 2^-29 of it by squares that underflow, and
// for shorter v, products of two lengths perhaps, the bound is only lower; below 0 it says nothing.
// Lines and estimates only choose v and an order: determinants and squares below kTinySquare count
// as that, so quotients are finite, or infinite and clamped, and never 0 over 0. A line is not
// longer than its estimate, or shorter than 2^-60, as NearFilter::direction needs. Squares of gaps
// and of the reach are near_pose.h's.

/// Edges of a facet, from each corner to the next.
struct Edges {
  explicit Edges(const Facet& f) {
    for (std::size_t i = 0; i < 3; ++i) {
      edge[i] = minus(f.corner[(i + 1) % 3], f.corner[i]);
      const Wide square = dot<Wide>(edge[i], edge[i]);
      squares[i] = square;
      inverse[i] = Wide(1.0F) / max(square, Wide(kTinySquare));
    }
  }

  static constexpr float kTinySquare = 0x1p-100F;

  std::array<Vectors, 3> edge;
  std::array<Wide, 3> squares;
  std::array<Wide, 3> inverse;
};

/// The shortest line so far from a point of the first triangle to one of the second.
struct Shortest {
  void take(WideMask where, Wide length_squared, const Vectors& v) {
    square = select(where, length_squared, square);
    line = select(where, v, line);
  }

  Wide square = Wide(0x1p120F);
  Vectors line = {Wide(0.0F), Wide(0.0F), Wide(0.0F)};
};

inline Wide unit_clamped(Wide v) {
  return min(max(v, Wide(0.0F)), Wide(1.0F));
}

/// Edge i of `a` against edge j of `b` (Ericson 2004, 5.1.9).
inline void try_edges(const Facet& a, const Edges& of_a, std::size_t i, const Facet& b,
                      const Edges& of_b, std::size_t j, Shortest& best) {
  const Vectors& f = of_a.edge[i];
  const Vectors& g = of_b.edge[j];
  const Vectors from = minus(b.corner[j], a.corner[i]);
  const Wide c = dot<Wide>(f, from);
  const Wide h = dot<Wide>(g, from);
  const Wide m = dot<Wide>(f, g);
  const Wide det = max(of_a.squares[i] * of_b.squares[j] - m * m, Wide(Edges::kTinySquare));
  Wide s = unit_clamped((c * of_b.squares[j] - m * h) / det);
  const Wide t = unit_clamped((m * s - h) * of_b.inverse[j]);
  s = unit_clamped((m * t + c) * of_a.inverse[i]);
  Vectors line;
  for (std::size_t k = 0; k < 3; ++k) {
    line[k] = (from[k] + t * g[k]) - s * f[k];
  }
  const Wide square = dot<Wide>(line, line);
  best.take(best.square > square, square, line);
}

/// A facet's plane, with what tells whether a point lies above the facet.
struct Prism {
  Prism(const Facet& f, const Edges& of_f) : square(dot<Wide>(f.normal, f.normal)) {
    inverse = Wide(1.0F) / max(square, Wide(Edges::kTinySquare));
    for (std::size_t j = 0; j < 3; ++j) {
      inward[j] = cross(f.normal, of_f.edge[j]);
    }
  }

  Wide square;
  Wide inverse;
  std::array<Vectors, 3> inward;
};

/// Corners of `p` above facet `f`; `forward` if f is the first triangle.
inline void try_corners(const Facet& f, const Prism& prism, const Facet& p, bool forward,
                        Shortest& best) {
  for (const Vectors& corner : p.corner) {
    const Vectors from0 = minus(corner, f.corner[0]);
    const Wide inside = least(dot<Wide>(from0, prism.inward[0]),
                              dot<Wide>(minus(corner, f.corner[1]), prism.inward[1]),
                              dot<Wide>(minus(corner, f.corner[2]), prism.inward[2]));
    const Wide height = dot<Wide>(from0, f.normal);
    const Wide share = height * prism.inverse;
    const Wide square = height * share;
    const Wide factor = forward ? share : Wide(0.0F) - share;
    const Vectors line = {factor * f.normal[0], factor * f.normal[1], factor * f.normal[2]};
    best.take((best.square > square) & (inside > Wide(0.0F)), square, line);
  }
}

/// Greatest values of x's triangles along a direction.
inline Row8 greatest_along(const TriangleSlot& slot, const Three& direction) {
  const auto corner = [&](std::size_t k) {
    return dot<F8>(direction, {F8::load(slot.x[3 * k].data()), F8::load(slot.x[3 * k + 1].data()),
                               F8::load(slot.x[3 * k + 2].data())});
  };
  Row8 most;
  greatest(corner(0), corner(1), corner(2)).store(most.data());
  return most;
}

/// Pairs that neither the filter's direction nor the distance of their boxes parts by more than
/// the reach. Corners are off by e together, sums along the direction by less than 2 e |v|_1 in
/// all, as above; 4 e on an axis covers both for boxes. Roundings of the squares' sum and of the
/// reach's take less than 2^-21 of them.
inline std::uint64_t near_boxes(const BlockTask& task, const NearFilter& filter,
                                TriangleSlot& slot) {
  const std::array<Row8, 6> box = move_corners(task, slot);
  const Corners q = corners_of(*task.y);
  const F8 error(error_of(task) * 4);
  const F8 reach(filter.reach);
  const F8 reach_squared = reach * reach * F8(1 + 0x1p-20F);
  const Three direction = splat(filter.direction);
  const Row8 x_along = greatest_along(slot, direction);
  const F8 y_along =
      least(dot<F8>(direction, q[0]), dot<F8>(direction, q[1]), dot<F8>(direction, q[2])) - error;
  Three lower;
  Three upper;
  for (std::size_t i = 0; i < 3; ++i) {
    lower[i] = least(q[0][i], q[1][i], q[2][i]) - error;
    upper[i] = greatest(q[0][i], q[1][i], q[2][i]) + error;
  }
  std::uint64_t rows = 0;
  for (std::uint32_t left = task.lanes_x; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    F8 square(0.0F);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const F8 gap =
          max(max(lower[axis] - F8(box[2 * axis + 1][i]), F8(box[2 * axis][i]) - upper[axis]),
              F8(0.0F));
      square = square + gap * gap;
    }
    const M8 miss = (square > reach_squared) | (y_along - F8(x_along[i]) > reach);
    rows |= std::uint64_t{~bits(miss) & task.lanes_y} << (8 * i);
  }
  if (rows != 0) {
    complete_slot(task, q, slot);
  }
  return rows;
}

inline std::array<Wide, 3> heights(const Facet& f, const Vectors& v) {
  return {dot<Wide>(v, f.corner[0]), dot<Wide>(v, f.corner[1]), dot<Wide>(v, f.corner[2])};
}

/// Gap of two facets along `v`, either way round, over v's length.
inline Wide gap_along(const Facet& a, const Facet& b, const Vectors& v, Wide error) {
  const auto on_a = heights(a, v);
  const auto on_b = heights(b, v);
  const Wide forward = least(on_b[0], on_b[1], on_b[2]) - greatest(on_a[0], on_a[1], on_a[2]);
  const Wide backward = least(on_a[0], on_a[1], on_a[2]) - greatest(on_b[0], on_b[1], on_b[2]);
  const Wide gap =
      (max(forward, backward) - Wide(2.0F) * error * sum_of_magnitudes(v)) - Wide(kLeastProduct);
  return gap / max(sqrt(dot<Wide>(v, v)), Wide(0x1p-60F));
}

inline void near_wide(const float* slots, const std::uint32_t* first, const std::uint32_t* second,
                      Wide reach, std::size_t begin, PairGaps& gaps) {
  const Facet a = facet_at(slots, first);
  const Facet b = facet_at(slots, second);
  const Wide error = Wide::gather(slots + TriangleBlock::kWidth * TriangleSlot::kErrorRow, first);
  const Wide planes =
      max(gap_along(a, b, a.normal, error), gap_along(a, b, b.normal, error)) * Wide(1 - 0x1p-20F);
  if (bits(planes > reach) == kAllWide) {
    planes.store(gaps.lower.data() + begin);
    Wide(std::numeric_limits<float>::infinity()).store(gaps.estimate.data() + begin);
    return;
  }
  const Edges of_a(a);
  const Edges of_b(b);
  Shortest best;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      try_edges(a, of_a, i, b, of_b, j, best);
    }
  }
  try_corners(a, Prism(a, of_a), b, true, best);
  try_corners(b, Prism(b, of_b), a, false, best);
  const Wide along = gap_along(a, b, best.line, error) * Wide(1 - 0x1p-20F);
  const Wide lower = max(planes, along);
  lower.store(gaps.lower.data() + begin);
  gaps.near |= (~bits(lower > reach) & kAllWide) << begin;
  sqrt(best.square).store(gaps.estimate.data() + begin);
  for (std::size_t i = 0; i < 3; ++i) {
    best.line[i].store(gaps.line[i].data() + begin);
  }
}

inline void near_pairs(const TriangleSlot* slots, const std::uint32_t* first,
                       const std::uint32_t* second, std::size_t count, float reach,
                       PairGaps& gaps) {
  const auto* floats = reinterpret_cast<const float*>(slots);
  gaps.near = 0;
  for (std::size_t begin = 0; begin < count; begin += kWide) {
    near_wide(floats, first + begin, second + begin, Wide(reach), begin, gaps);
  }
  gaps.near &= (1U << count) - 1;
}
