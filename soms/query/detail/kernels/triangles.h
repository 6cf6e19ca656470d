// Kernels of blocks, for any kind of eight lanes F8. Included once for each instruction set, inside
// its namespace and after its F8; so it has no include guard and includes nothing.

using Three = std::array<F8, 3>;

/// Covers what underflows in products of three or four lengths.
inline constexpr float kLeastProduct = 0x1p-140F;

inline F8 least(F8 a, F8 b, F8 c) {
  return min(a, min(b, c));
}

inline F8 greatest(F8 a, F8 b, F8 c) {
  return max(a, max(b, c));
}

inline F8 dot(const Three& a, const Three& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

inline Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Three minus(const Three& a, const Three& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline F8 sum_of_magnitudes(const Three& n) {
  return (abs(n[0]) + abs(n[1])) + abs(n[2]);
}

template <std::size_t N>
inline Three splat(const std::array<float, N>& v) {
  return {F8(v[0]), F8(v[1]), F8(v[2])};
}

/// Corners of eight triangles.
using Corners = std::array<Three, 3>;

inline Corners corners_of(const TriangleBlock& block) {
  Corners q;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      q[corner][axis] = F8::load(block.corner[3 * corner + axis].data());
    }
  }
  return q;
}

/// Triangles of which some point lies between `lower` and `upper` on `direction`.
inline std::uint32_t between(const Corners& q, const Three& direction, float lower, float upper) {
  const F8 a = dot(direction, q[0]);
  const F8 b = dot(direction, q[1]);
  const F8 c = dot(direction, q[2]);
  return ~bits((least(a, b, c) > F8(upper)) | (F8(lower) > greatest(a, b, c)));
}

/// `(m0 v0 + m1 v1) + m2 v2` for rows or columns of a matrix.
inline F4 sum_of(const std::array<float, 16>& m, const std::array<float, 3>& v) {
  return (F4::load(m.data()) * F4(v[0]) + F4::load(m.data() + 4) * F4(v[1])) +
         F4::load(m.data() + 8) * F4(v[2]);
}

using Row = std::array<float, 4>;

inline Row stored(F4 v) {
  Row row;
  v.store(row.data());
  return row;
}

inline void test_slab(BlockTask& task) {
  const PoseNumbers& pose = *task.pose;
  const TriangleBlock& x = *task.x;
  const TriangleBlock& y = *task.y;
  const float ratio = pose.ratio;
  const F4 offset = offset_of(pose, x.origin, y.origin);
  const Row d = stored(offset);
  const float margin = pose.relative * (x.reach * ratio + y.reach) + pose.slack;
  const F4 normal_x = sum_of(pose.columns, x.normal);  // in y's axes
  const F4 normal_y = sum_of(pose.rows, y.normal);     // in x's
  const Row nx = stored(normal_x);
  const Row ny = stored(normal_y * F4(ratio));
  const Row px = stored(normal_x * offset);
  const Row py = stored(F4::load(y.normal.data()) * offset);
  const float along_x = (px[0] + px[1]) + px[2];
  const float along_y = (py[0] + py[1]) + py[2];
  task.offset = {d[0], d[1], d[2]};
  task.margin = margin;
  task.lanes_y = between(corners_of(y), splat(nx), (x.lower * ratio + along_x) - margin,
                         (x.upper * ratio + along_x) + margin) &
                 ((1U << y.count) - 1);
  task.lanes_x = between(corners_of(x), splat(ny), (y.lower - along_y) - margin,
                         (y.upper - along_y) + margin) &
                 ((1U << x.count) - 1);
}

inline void test_slabs(BlockTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    test_slab(tasks[i]);
  }
}

/// Triangles `q` that miss triangle `p`, the same in all lanes, along `n`.
inline M8 apart_along(const Three& n, const Corners& p, const Corners& q, float margin) {
  const F8 a = dot(n, p[0]);
  const F8 b = dot(n, p[1]);
  const F8 c = dot(n, p[2]);
  const F8 d = dot(n, q[0]);
  const F8 e = dot(n, q[1]);
  const F8 f = dot(n, q[2]);
  const F8 give = sum_of_magnitudes(n) * F8(margin) + F8(kLeastProduct);
  return (least(a, b, c) > greatest(d, e, f) + give) | (least(d, e, f) > greatest(a, b, c) + give);
}

/// Corners of x's triangles in y's axes, and their boxes: row, lane.
struct Moved {
  explicit Moved(const BlockTask& task) {
    const PoseNumbers& pose = *task.pose;
    const Corners own = corners_of(*task.x);
    const F8 ratio(pose.ratio);
    Corners seen;
    for (std::size_t k = 0; k < 3; ++k) {
      const Three v = {own[k][0] * ratio, own[k][1] * ratio, own[k][2] * ratio};
      for (std::size_t i = 0; i < 3; ++i) {
        seen[k][i] =
            dot({F8(pose.n(i, 0)), F8(pose.n(i, 1)), F8(pose.n(i, 2))}, v) + F8(task.offset[i]);
        seen[k][i].store(corner[3 * k + i].data());
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      least(seen[0][i], seen[1][i], seen[2][i]).store(lower[i].data());
      greatest(seen[0][i], seen[1][i], seen[2][i]).store(upper[i].data());
    }
  }

  [[nodiscard]] Corners lane(std::size_t k) const {
    Corners p;
    for (std::size_t row = 0; row < 9; ++row) {
      p[row / 3][row % 3] = F8(corner[row][k]);
    }
    return p;
  }

  alignas(32) std::array<std::array<float, 8>, 9> corner;
  alignas(32) std::array<std::array<float, 8>, 3> lower;
  alignas(32) std::array<std::array<float, 8>, 3> upper;
};

/// Triangles `q` that miss `p` along a product of two edges.
inline M8 apart_by_edges(const Corners& p, const Corners& q, float margin) {
  M8 miss = apart_along(cross(minus(p[1], p[0]), minus(q[1], q[0])), p, q, margin);
  for (std::size_t k = 1; k < 9; ++k) {
    const Three edge = minus(p[(k / 3 + 1) % 3], p[k / 3]);
    const Three other = minus(q[(k % 3 + 1) % 3], q[k % 3]);
    miss = miss | apart_along(cross(edge, other), p, q, margin);
  }
  return miss;
}

inline std::uint64_t test_triangles(const BlockTask& task) {
  const Moved moved(task);
  const Corners q = corners_of(*task.y);
  const float margin = task.margin;
  const Three normal = cross(minus(q[1], q[0]), minus(q[2], q[0]));
  Three lower;
  Three upper;
  for (std::size_t i = 0; i < 3; ++i) {
    lower[i] = least(q[0][i], q[1][i], q[2][i]) - F8(margin);
    upper[i] = greatest(q[0][i], q[1][i], q[2][i]) + F8(margin);
  }
  std::uint64_t rows = 0;
  for (std::uint32_t left = task.lanes_x; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    M8 miss = (lower[0] > F8(moved.upper[0][i])) | (F8(moved.lower[0][i]) > upper[0]);
    for (std::size_t axis = 1; axis < 3; ++axis) {
      miss = miss | (lower[axis] > F8(moved.upper[axis][i])) |
             (F8(moved.lower[axis][i]) > upper[axis]);
    }
    std::uint32_t meet = ~bits(miss) & task.lanes_y;
    if (meet == 0) {
      continue;
    }
    const Corners p = moved.lane(i);
    meet &= ~bits(apart_along(normal, p, q, margin));
    if (meet == 0) {
      continue;
    }
    meet &= ~bits(apart_along(cross(minus(p[1], p[0]), minus(p[2], p[0])), p, q, margin));
    if (meet == 0) {
      continue;
    }
    meet &= ~bits(apart_by_edges(p, q, margin));
    rows |= std::uint64_t{meet} << (8 * i);
  }
  return rows;
}
