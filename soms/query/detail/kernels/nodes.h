// Kernels of nodes, for any kind of four lanes F4. Included once for each instruction set, inside
// its namespace and after its F4; so it has no include guard and includes nothing.
//
// Underflow. Lengths are multiplied by entries of rotations and ratios alone and lose 2^-150 each
// time, less than 2^-145 in all: the margin has 2^-100 for that. Squares, in `distances`, only say
// which pair comes first.

/// M and d of relative_pose.h, and the margin.
struct Seen {
  Seen(const PoseNumbers& pose, const WideNode& x, const WideNode& y) {
    offset_of(pose, x.origin, y.origin).store(d.data());
    // Most large nodes have the mesh's axes: with those, the products would change nothing.
    if ((x.oriented | y.oriented) != 0) {
      turn(pose, x, y);
    } else {
      m = pose.rows.data();
      a = pose.magnitudes.data();
    }
    margin = pose.relative * (x.l1_radius * pose.ratio + y.l1_radius) + pose.slack;
  }

  Seen(const Seen&) = delete;
  Seen& operator=(const Seen&) = delete;
  ~Seen() = default;

  void turn(const PoseNumbers& pose, const WideNode& x, const WideNode& y) {
    std::array<F4, 3> half_rotated;  // the offset rides in the fourth lane
    for (std::size_t i = 0; i < 3; ++i) {
      half_rotated[i] = with_last((F4::load(x.row[0].data()) * F4(pose.n(i, 0)) +
                                   F4::load(x.row[1].data()) * F4(pose.n(i, 1))) +
                                      F4::load(x.row[2].data()) * F4(pose.n(i, 2)),
                                  d[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const F4 row = (half_rotated[0] * F4(y.row[0][i]) + half_rotated[1] * F4(y.row[1][i])) +
                     half_rotated[2] * F4(y.row[2][i]);
      row.store(own.data() + 4 * i);
      abs(row).store(own_magnitudes.data() + 4 * i);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      d[i] = own[4 * i + 3];
    }
    m = own.data();
    a = own_magnitudes.data();
  }

  const float* m;  // rows of four
  const float* a;  // their magnitudes
  std::array<float, 4> d;
  float margin;
  std::array<float, 12> own;
  std::array<float, 12> own_magnitudes;
};

/// Centers of the boxes of two nodes, in one node's axes.
struct Centers {
  std::array<F4, 3> x;
  std::array<F4, 3> y;
};

/// Squares of the distances between centers of x and, turned by `R` lanes, of y.
template <int R>
inline F4 distances(const Centers& c) {
  std::array<F4, 3> square;
  for (std::size_t i = 0; i < 3; ++i) {
    const F4 between = c.x[i] - rotate<R>(c.y[i]);
    square[i] = between * between;
  }
  return (square[0] + square[2]) + square[1];
}

/// What is added to the distances of a set of lanes so that only these count.
struct Outside {
  std::array<std::array<float, 4>, 16> lanes = {};

  constexpr Outside() {
    for (std::size_t set = 0; set < 16; ++set) {
      for (std::size_t k = 0; k < 4; ++k) {
        lanes[set][k] = (set >> k & 1U) != 0 ? 0 : std::numeric_limits<float>::infinity();
      }
    }
  }
};

inline constexpr Outside kOutside;

/// See NodeTask::below; all bits where no pair is set.
inline std::uint32_t below_nearest(const Centers& centers, std::uint32_t pairs) {
  const auto outside = [pairs](std::uint32_t r) {
    return F4::load(kOutside.lanes[pairs >> 4 * r & 0xf].data());
  };
  const std::array<F4, 4> distance = {
      distances<0>(centers) + outside(0), distances<1>(centers) + outside(1),
      distances<2>(centers) + outside(2), distances<3>(centers) + outside(3)};
  F4 least = min(min(distance[0], distance[1]), min(distance[2], distance[3]));
  least = min(least, rotate<2>(least));
  least = min(least, rotate<1>(least));
  const std::uint32_t farther = bits(distance[0] > least) | bits(distance[1] > least) << 4 |
                                bits(distance[2] > least) << 8 | bits(distance[3] > least) << 12;
  const std::uint32_t nearest = pairs & ~farther;
  return (nearest & (0 - nearest)) - 1;
}

/// x's box of all lanes against the boxes of y.
inline std::uint32_t one_against_four(const PoseNumbers& pose, const WideNode& x,
                                      const WideNode& y) {
  const Seen seen(pose, x, y);
  const float* const m = seen.m;
  const float* const a = seen.a;
  const std::array<float, 3> h = {x.row[0][3] * pose.ratio, x.row[1][3] * pose.ratio,
                                  x.row[2][3] * pose.ratio};
  std::array<F4, 3> gap;
  std::array<F4, 3> half;
  M4 sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const float radius =
        ((a[4 * i] * h[0] + a[4 * i + 1] * h[1]) + a[4 * i + 2] * h[2]) + seen.margin;
    half[i] = F4::load(y.half[i].data());
    gap[i] = F4::load(y.center[i].data()) - F4(seen.d[i]);
    const M4 apart = abs(gap[i]) > half[i] + F4(radius);
    sum = i == 0 ? apart : sum | apart;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const F4 along = (gap[0] * F4(m[j]) + gap[1] * F4(m[4 + j])) + gap[2] * F4(m[8 + j]);
    const F4 radius = (half[0] * F4(a[j]) + half[1] * F4(a[4 + j])) + half[2] * F4(a[8 + j]);
    sum = sum | (abs(along) > radius + F4(h[j] + seen.margin));
  }
  return ~bits(sum);
}

/// The boxes of x against y's box of all lanes.
inline std::uint32_t four_against_one(const PoseNumbers& pose, const WideNode& x,
                                      const WideNode& y) {
  const Seen seen(pose, x, y);
  const float* const m = seen.m;
  const float* const a = seen.a;
  const std::array<float, 3> h = {y.row[0][3], y.row[1][3], y.row[2][3]};
  std::array<F4, 3> center;
  std::array<F4, 3> half;
  for (std::size_t i = 0; i < 3; ++i) {
    center[i] = F4::load(x.center[i].data()) * F4(pose.ratio);
    half[i] = F4::load(x.half[i].data()) * F4(pose.ratio);
  }
  std::array<F4, 3> gap;
  M4 sum;
  for (std::size_t i = 0; i < 3; ++i) {
    gap[i] =
        ((center[0] * F4(m[4 * i]) + center[1] * F4(m[4 * i + 1])) + center[2] * F4(m[4 * i + 2])) +
        F4(seen.d[i]);
    const F4 radius =
        (half[0] * F4(a[4 * i]) + half[1] * F4(a[4 * i + 1])) + half[2] * F4(a[4 * i + 2]);
    const M4 apart = abs(gap[i]) > radius + F4(h[i] + seen.margin);
    sum = i == 0 ? apart : sum | apart;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const F4 along = (gap[0] * F4(m[j]) + gap[1] * F4(m[4 + j])) + gap[2] * F4(m[8 + j]);
    const float radius = ((a[j] * h[0] + a[4 + j] * h[1]) + a[8 + j] * h[2]) + seen.margin;
    sum = sum | (abs(along) > half[j] + F4(radius));
  }
  return ~bits(sum);
}

inline void test_larger(NodeTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const NodeTask& task = tasks[i];
    tasks[i].pairs &= task.descends_x() ? four_against_one(*task.pose, *task.x, *task.y)
                                        : one_against_four(*task.pose, *task.x, *task.y);
  }
}
