// All lanes of two nodes by four lanes at a time; see nodes.h, also for what underflows.

/// Intervals of four boxes on three axes.
struct Intervals {
  std::array<F4, 3> lower;
  std::array<F4, 3> upper;

  Intervals(const std::array<F4, 3>& center, const std::array<F4, 3>& radius) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = center[i] - radius[i];
      upper[i] = center[i] + radius[i];
    }
  }
};

/// Lanes of `a` whose intervals miss those of `b`, turned by `R` lanes, on some axis.
template <int R>
inline M4 apart(const Intervals& a, const Intervals& b) {
  M4 sum = (a.lower[0] > rotate<R>(b.upper[0])) | (rotate<R>(b.lower[0]) > a.upper[0]);
  for (std::size_t i = 1; i < 3; ++i) {
    sum = sum | (a.lower[i] > rotate<R>(b.upper[i])) | (rotate<R>(b.lower[i]) > a.upper[i]);
  }
  return sum;
}

inline std::uint32_t test_pair(const PoseNumbers& pose, const WideNode& x, const WideNode& y,
                               Centers* centers) {
  const Seen seen(pose, x, y);
  const float* const m = seen.m;
  const float* const a = seen.a;
  const F4 margin(seen.margin);
  std::array<F4, 3> cx;
  std::array<F4, 3> hx;
  std::array<F4, 3> cy;
  std::array<F4, 3> hy;
  std::array<F4, 3> away;
  for (std::size_t i = 0; i < 3; ++i) {
    cx[i] = F4::load(x.center[i].data()) * F4(pose.ratio);
    hx[i] = F4::load(x.half[i].data()) * F4(pose.ratio);
    cy[i] = F4::load(y.center[i].data());
    hy[i] = F4::load(y.half[i].data());
    away[i] = cy[i] - F4(seen.d[i]);
  }
  std::array<F4, 3> seen_x;
  std::array<F4, 3> radius_x;
  std::array<F4, 3> seen_y;
  std::array<F4, 3> radius_y;
  for (std::size_t i = 0; i < 3; ++i) {
    seen_x[i] = ((cx[0] * F4(m[4 * i]) + cx[1] * F4(m[4 * i + 1])) + cx[2] * F4(m[4 * i + 2])) +
                F4(seen.d[i]);
    radius_x[i] =
        ((hx[0] * F4(a[4 * i]) + hx[1] * F4(a[4 * i + 1])) + hx[2] * F4(a[4 * i + 2])) + margin;
    seen_y[i] = (away[0] * F4(m[i]) + away[1] * F4(m[4 + i])) + away[2] * F4(m[8 + i]);
    radius_y[i] = ((hy[0] * F4(a[i]) + hy[1] * F4(a[4 + i])) + hy[2] * F4(a[8 + i])) + margin;
  }
  if (centers != nullptr) {
    *centers = {seen_x, cy};
  }
  const Intervals x_in_y(seen_x, radius_x);
  const Intervals y_in_y(cy, hy);
  const Intervals x_in_x(cx, hx);
  const Intervals y_in_x(seen_y, radius_y);
  return ~(bits(apart<0>(x_in_y, y_in_y) | apart<0>(x_in_x, y_in_x)) |
           bits(apart<1>(x_in_y, y_in_y) | apart<1>(x_in_x, y_in_x)) << 4 |
           bits(apart<2>(x_in_y, y_in_y) | apart<2>(x_in_x, y_in_x)) << 8 |
           bits(apart<3>(x_in_y, y_in_y) | apart<3>(x_in_x, y_in_x)) << 12);
}

inline void test_nodes(NodeTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    NodeTask& task = tasks[i];
    if (task.order == 0) {
      task.pairs &= test_pair(*task.pose, *task.x, *task.y, nullptr);
    } else {
      Centers centers;
      task.pairs &= test_pair(*task.pose, *task.x, *task.y, &centers);
      task.below = below_nearest(centers, task.node_ids());
    }
  }
}
