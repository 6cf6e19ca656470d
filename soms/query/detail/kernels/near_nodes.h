// Lower bounds of the distances between boxes of two nodes, for any kind of lanes Wide. Included
// after triangle_pairs.h, once for each instruction set. near_pose.h proves them, and what
// products, squares and quotients that underflow lose.

inline constexpr std::uint32_t kAllWide = (1U << kWide) - 1;

/// Two nodes' boxes along the axes of both; `m` and `margin` as in Seen.
struct BoxPair {
  BoxPair(const PoseNumbers& pose, const WideNode& x, const WideNode& y)
      : seen(pose, x, y),
        margin(pose.relative * (x.l1_radius * pose.ratio + y.l1_radius) + pose.rounding) {
    const float* const m = seen.m;
    const float* const a = seen.a;
    for (std::size_t i = 0; i < 3; ++i) {
      center_x[i] = F4::load(x.center[i].data()) * F4(pose.ratio);
      half_x[i] = F4::load(x.half[i].data()) * F4(pose.ratio);
      center_y[i] = F4::load(y.center[i].data());
      half_y[i] = F4::load(y.half[i].data());
    }
    for (std::size_t i = 0; i < 3; ++i) {
      seen_x[i] = ((center_x[0] * F4(m[4 * i]) + center_x[1] * F4(m[4 * i + 1])) +
                   center_x[2] * F4(m[4 * i + 2])) +
                  F4(seen.d[i]);
      radius_x[i] =
          (half_x[0] * F4(a[4 * i]) + half_x[1] * F4(a[4 * i + 1])) + half_x[2] * F4(a[4 * i + 2]);
      radius_y[i] = (half_y[0] * F4(a[i]) + half_y[1] * F4(a[4 + i])) + half_y[2] * F4(a[8 + i]);
    }
  }

  Seen seen;
  float margin;
  std::array<F4, 3> center_x;
  std::array<F4, 3> half_x;
  std::array<F4, 3> center_y;
  std::array<F4, 3> half_y;
  std::array<F4, 3> seen_x;    // centers of x along y's axes
  std::array<F4, 3> radius_x;  // half sides of x's boxes along y's axes
  std::array<F4, 3> radius_y;  // and the reverse
};

/// `m` from the right, and from the left.
inline Vectors along_rows(const float* m, const Vectors& v) {
  Vectors product;
  for (std::size_t i = 0; i < 3; ++i) {
    product[i] = (v[0] * Wide(m[4 * i]) + v[1] * Wide(m[4 * i + 1])) + v[2] * Wide(m[4 * i + 2]);
  }
  return product;
}

inline Vectors along_columns(const float* m, const Vectors& v) {
  Vectors product;
  for (std::size_t j = 0; j < 3; ++j) {
    product[j] = (v[0] * Wide(m[j]) + v[1] * Wide(m[4 + j])) + v[2] * Wide(m[8 + j]);
  }
  return product;
}

/// Gaps between boxes along three axes.
struct AxisGaps {
  AxisGaps(const Vectors& between, const Vectors& radius_a, const Vectors& radius_b, Wide margin) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Wide gap = (abs(between[i]) - (radius_a[i] + radius_b[i])) - margin;
      const Wide beyond = max(gap, Wide(0.0F));
      most = i == 0 ? gap : max(most, gap);
      square = i == 0 ? beyond * beyond : square + beyond * beyond;
    }
  }

  Wide most;
  Wide square;
};

inline Wide clamped(Wide v, Wide half) {
  return min(max(v, Wide(0.0F) - half), half);
}

/// Bounds of the pairs of as many rotations as Wide holds, from rotation R on.
template <int R>
inline void bound_rotations(const BoxPair& boxes, float shrink, float limit, NodeKeys& keys) {
  const float* const m = boxes.seen.m;
  const Wide margin(boxes.margin);
  Vectors half_x;
  Vectors half_y;
  Vectors radius_x;
  Vectors radius_y;
  Vectors between;
  for (std::size_t i = 0; i < 3; ++i) {
    half_x[i] = repeated(boxes.half_x[i]);
    half_y[i] = rotations<R>(boxes.half_y[i]);
    radius_x[i] = repeated(boxes.radius_x[i]);
    radius_y[i] = rotations<R>(boxes.radius_y[i]);
    between[i] = rotations<R>(boxes.center_y[i]) - repeated(boxes.seen_x[i]);
  }
  const Vectors between_in_x = along_columns(m, between);
  const AxisGaps in_y(between, radius_x, half_y, margin);
  const AxisGaps in_x(between_in_x, half_x, radius_y, margin);
  const Wide length = sqrt(max(in_y.square, in_x.square));
  // From the center of x to the nearest point of y, and from there to the nearest of x: the
  // direction of that is a better one than the axes, as a rule.
  Vectors to_y;
  for (std::size_t i = 0; i < 3; ++i) {
    to_y[i] = between[i] - clamped(between[i], half_y[i]);
  }
  Vectors way = along_columns(m, to_y);
  for (std::size_t j = 0; j < 3; ++j) {
    way[j] = way[j] - clamped(way[j], half_x[j]);
  }
  const Vectors way_in_y = along_rows(m, way);
  const Vectors size = {abs(way[0]), abs(way[1]), abs(way[2])};
  const Vectors size_in_y = {abs(way_in_y[0]), abs(way_in_y[1]), abs(way_in_y[2])};
  const Wide gap =
      ((dot<Wide>(way, between_in_x) - dot<Wide>(size, half_x)) - dot<Wide>(size_in_y, half_y)) -
      sum_of_magnitudes(way) * margin;
  const Wide along = (gap - Wide(kLeastProduct)) / max(sqrt(dot<Wide>(way, way)), Wide(0x1p-60F));
  const Wide most = max(in_y.most, in_x.most);
  const Wide key = select(most > Wide(0.0F), max(length, along) * Wide(shrink), most);
  key.store(keys.key.data() + std::size_t{4} * R);
  keys.near |= (~bits(key > Wide(limit)) & kAllWide) << (4 * R);
}

template <int R>
inline void bound_from(const NodeTask& task, const BoxPair& boxes, float limit, NodeKeys& keys) {
  if ((task.pairs >> (4 * R) & kAllWide) != 0) {
    bound_rotations<R>(boxes, task.pose->shrink, limit, keys);
  }
  constexpr int kNext = R + static_cast<int>(kWide / 4);
  if constexpr (kNext < 4) {
    bound_from<kNext>(task, boxes, limit, keys);
  }
}

inline void bound_nodes(const NodeTask* tasks, std::size_t count, float limit, NodeKeys* keys) {
  for (std::size_t i = 0; i < count; ++i) {
    const BoxPair boxes(*tasks[i].pose, *tasks[i].x, *tasks[i].y);
    keys[i].near = 0;
    bound_from<0>(tasks[i], boxes, limit, keys[i]);
    keys[i].near &= tasks[i].pairs;
  }
}
