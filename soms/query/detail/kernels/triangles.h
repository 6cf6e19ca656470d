// Kernels of blocks, for any kind of eight lanes F8. Included once for each instruction set, inside
// its namespace and after its F8; so it has no include guard and includes nothing.
//
// Underflow. Here a length is multiplied by what is at most about 1, an entry of a rotation, of a
// unit normal or a ratio, and loses 2^-150; what is multiplied once or twice so loses less than
// 2^-146. All such lengths are compared with or have an error of `slack` or `rounding`, of which
// 2^-100 is for that (relative_pose.h). Roundings are counted there and in triangle_pairs.h.

/// Three coordinates in lanes F.
template <class F>
using Coordinates = std::array<F, 3>;
using Three = Coordinates<F8>;

template <class F>
inline F least(F a, F b, F c) {
  return min(a, min(b, c));
}

template <class F>
inline F greatest(F a, F b, F c) {
  return max(a, max(b, c));
}

template <class F>
inline F dot(const Coordinates<F>& a, const Coordinates<F>& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
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
  const F8 a = dot<F8>(direction, q[0]);
  const F8 b = dot<F8>(direction, q[1]);
  const F8 c = dot<F8>(direction, q[2]);
  return ~bits((least(a, b, c) > F8(upper)) | (F8(lower) > greatest(a, b, c)));
}

/// `(m0 v0 + m1 v1) + m2 v2` for rows or columns of a matrix.
inline F4 sum_of(const std::array<float, 16>& m, const std::array<float, 3>& v) {
  return (F4::load(m.data()) * F4(v[0]) + F4::load(m.data() + 4) * F4(v[1])) +
         F4::load(m.data() + 8) * F4(v[2]);
}

using Row = std::array<float, 4>;

using Row8 = std::array<float, 8>;

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
  const float margin = pose.relative * (x.l1_radius * ratio + y.l1_radius) + pose.slack;
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

/// What corners may be off by; triangle_pairs.h proves it.
inline float error_of(const BlockTask& task) {
  const auto& d = task.offset;
  const float distance = (std::abs(d[0]) + std::abs(d[1])) + std::abs(d[2]);
  const float l1_radius = task.x->l1_radius * task.pose->ratio + task.y->l1_radius;
  return (l1_radius + distance) * 0x1p-21F + task.pose->rounding * 0x1p-1F;
}

/// Moves the corners of x into the slot; gives their boxes, for each axis the rows of lower and
/// upper ends.
inline std::array<Row8, 6> move_corners(const BlockTask& task, TriangleSlot& slot) {
  const PoseNumbers& pose = *task.pose;
  const Corners own = corners_of(*task.x);
  const F8 ratio(pose.ratio);
  Corners seen;
  for (std::size_t k = 0; k < 3; ++k) {
    const Three v = {own[k][0] * ratio, own[k][1] * ratio, own[k][2] * ratio};
    for (std::size_t i = 0; i < 3; ++i) {
      seen[k][i] =
          dot<F8>({F8(pose.n(i, 0)), F8(pose.n(i, 1)), F8(pose.n(i, 2))}, v) + F8(task.offset[i]);
      seen[k][i].store(slot.x[3 * k + i].data());
    }
  }
  std::array<Row8, 6> box;
  for (std::size_t i = 0; i < 3; ++i) {
    least(seen[0][i], seen[1][i], seen[2][i]).store(box[2 * i].data());
    greatest(seen[0][i], seen[1][i], seen[2][i]).store(box[2 * i + 1].data());
  }
  return box;
}

/// What `move_corners` leaves to be filled in.
inline void complete_slot(const BlockTask& task, const Corners& y, TriangleSlot& slot) {
  const F8 error(error_of(task));
  for (std::size_t row = 0; row < 9; ++row) {
    y[row / 3][row % 3].store(slot.y[row].data());
  }
  error.store(slot.x[TriangleSlot::kErrorRow].data());
  error.store(slot.y[TriangleSlot::kErrorRow].data());
  slot.id_x = task.x->id;
  slot.id_y = task.y->id;
}

/// What `judge_in_double` needs of a slot beside the corners of y; triangle_pairs_double.h proves
/// the errors.
inline void complete_for_double(const BlockTask& task, TriangleSlot& slot) {
  const PoseNumbers& pose = *task.pose;
  const Corners own = corners_of(*task.x);
  const F8 ratio(pose.ratio);
  for (std::size_t row = 0; row < 9; ++row) {
    (own[row / 3][row % 3] * ratio).store(slot.own[row].data());
  }
  slot.offset = pose.offset_in_double(task.x->origin, task.y->origin);
  const auto& d = slot.offset;
  const double radius_x = double{task.x->l1_radius} * double{pose.ratio};
  const double radius_y = task.y->l1_radius;
  const double reach = (radius_x + radius_y) + ((std::abs(d[0]) + std::abs(d[1])) + std::abs(d[2]));
  const double shared = 0.5 * double{pose.rounding} + 0x1p-48 * reach;
  slot.error_x = 1.05 * 0x1p-24 * radius_x + shared;
  slot.error_y = 1.05 * 0x1p-24 * radius_y + shared;
}

inline std::uint64_t test_boxes(const BlockTask& task, TriangleSlot& slot) {
  const std::array<Row8, 6> box = move_corners(task, slot);
  const Corners q = corners_of(*task.y);
  const F8 margin(task.margin);
  Three lower;
  Three upper;
  for (std::size_t i = 0; i < 3; ++i) {
    lower[i] = least(q[0][i], q[1][i], q[2][i]) - margin;
    upper[i] = greatest(q[0][i], q[1][i], q[2][i]) + margin;
  }
  std::uint64_t rows = 0;
  for (std::uint32_t left = task.lanes_x; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    M8 miss = (lower[0] > F8(box[1][i])) | (F8(box[0][i]) > upper[0]);
    for (std::size_t axis = 1; axis < 3; ++axis) {
      miss = miss | (lower[axis] > F8(box[2 * axis + 1][i])) | (F8(box[2 * axis][i]) > upper[axis]);
    }
    rows |= std::uint64_t{~bits(miss) & task.lanes_y} << (8 * i);
  }
  if (rows != 0) {
    complete_slot(task, q, slot);
    complete_for_double(task, slot);
  }
  return rows;
}
