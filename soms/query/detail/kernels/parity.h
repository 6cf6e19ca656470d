// Kernels of rays along an axis, for any kind of four lanes F4 and eight lanes F8. Included once
// for each instruction set, inside its namespace and after triangles.h; so it has no include guard
// and includes nothing. parity_frame.h proves the margins, and says of each product here what
// covers it where it underflows.

/// B of the proof: from the point to a node's or block's origin, along the ray and across it.
inline std::array<float, 3> seen_from(const RayNumbers& numbers, const RayStart& start,
                                      const std::array<double, 3>& origin) {
  std::array<float, 3> seen;
  if (numbers.rotated) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<double, 3>& r = numbers.exact[i];
      const double turned = (r[0] * origin[0] + r[1] * origin[1]) + r[2] * origin[2];
      seen[i] = static_cast<float>((start.from[i] + turned) * numbers.scale);
    }
  } else {
    for (std::size_t i = 0; i < 3; ++i) {
      seen[i] = static_cast<float>((start.from[i] + origin[numbers.axis[i]]) * numbers.scale);
    }
  }
  return seen;
}

/// What tests of a node give way by: along the ray, and across it.
struct RayMargins {
  RayMargins(const RayNumbers& numbers, const WideNode& node, const std::array<float, 3>& seen)
      : along((node.l1_radius + std::abs(seen[0])) * 0x1p-19F + numbers.slack),
        across((node.l1_radius + (std::abs(seen[1]) + std::abs(seen[2]))) * 0x1p-19F +
               numbers.slack) {}

  float along;
  float across;
};

/// Boxes along the world's axes.
inline std::uint32_t meet_upright(const RayNodeTask& task, const std::array<float, 3>& seen) {
  const WideNode& node = *task.node;
  const auto& axis = task.numbers->axis;
  const RayMargins margin(*task.numbers, node, seen);
  M4 apart;
  for (std::size_t i = 1; i < 3; ++i) {
    const M4 beside = abs(F4::load(node.center[axis[i]].data()) + F4(seen[i])) >
                      F4::load(node.half[axis[i]].data()) + F4(margin.across);
    apart = i == 1 ? beside : apart | beside;
  }
  const F4 ahead = (F4::load(node.center[axis[0]].data()) + F4(seen[0])) * F4(task.start->sign);
  const F4 reach = F4::load(node.half[axis[0]].data()) + F4(margin.along);
  return ~bits(apart | (F4(0.0F) > ahead + reach));
}

/// Rows of R Q: a node's axes as the world sees them.
using RayRows = std::array<std::array<float, 4>, 3>;

inline std::array<float, 4> turned_row(const std::array<float, 4>& r, const WideNode& node) {
  std::array<float, 4> row;
  ((F4::load(node.row[0].data()) * F4(r[0]) + F4::load(node.row[1].data()) * F4(r[1])) +
   F4::load(node.row[2].data()) * F4(r[2]))
      .store(row.data());
  return row;
}

inline RayRows rows_of(const RayNumbers& numbers, const WideNode& node) {
  RayRows rows;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!numbers.rotated) {
      rows[i] = node.row[numbers.axis[i]];
    } else if (node.oriented == 0) {
      rows[i] = numbers.row[i];
    } else {
      rows[i] = turned_row(numbers.row[i], node);
    }
  }
  return rows;
}

inline F4 along_row(const std::array<float, 4>& row, const std::array<F4, 3>& v) {
  return (F4(row[0]) * v[0] + F4(row[1]) * v[1]) + F4(row[2]) * v[2];
}

/// A node's boxes along its own axes.
struct Boxes {
  explicit Boxes(const WideNode& node) {
    for (std::size_t k = 0; k < 3; ++k) {
      center[k] = F4::load(node.center[k].data());
      half[k] = F4::load(node.half[k].data());
    }
  }

  std::array<F4, 3> center;
  std::array<F4, 3> half;
};

/// Boxes that a ray misses: seen along it they are hexagons, each three strips at once.
inline M4 beside_strips(const std::array<float, 4>& y, const std::array<float, 4>& z,
                        const std::array<float, 3>& seen, const Boxes& boxes, float across) {
  std::array<float, 3> ray;  // magnitudes of the ray's direction along the node's axes
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    ray[k] = std::abs(y[i] * z[j] - y[j] * z[i]);
  }
  const F4 to_y = along_row(y, boxes.center) + F4(seen[1]);
  const F4 to_z = along_row(z, boxes.center) + F4(seen[2]);
  M4 apart;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    const F4 gap = abs(F4(y[k]) * to_z - F4(z[k]) * to_y);
    const F4 radius = F4(ray[j]) * boxes.half[i] + F4(ray[i]) * boxes.half[j];
    const M4 beside = gap > radius + F4(across);
    apart = k == 0 ? beside : apart | beside;
  }
  return apart;
}

/// Boxes along any axes.
inline std::uint32_t meet_oriented(const RayNodeTask& task, const std::array<float, 3>& seen) {
  const WideNode& node = *task.node;
  const RayMargins margin(*task.numbers, node, seen);
  const RayRows rows = rows_of(*task.numbers, node);
  const Boxes boxes(node);
  const M4 apart = beside_strips(rows[1], rows[2], seen, boxes, margin.across * 1.5F);
  const auto& x = rows[0];
  const F4 ahead = (along_row(x, boxes.center) + F4(seen[0])) * F4(task.start->sign);
  const F4 reach = along_row({std::abs(x[0]), std::abs(x[1]), std::abs(x[2]), 0}, boxes.half);
  return ~bits(apart | (F4(0.0F) > ahead + (reach + F4(margin.along))));
}

inline void ray_nodes(RayNodeTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    RayNodeTask& task = tasks[i];
    const WideNode& node = *task.node;
    const std::array<float, 3> seen = seen_from(*task.numbers, *task.start, node.origin);
    const std::uint32_t meet = task.numbers->rotated || node.oriented != 0
                                   ? meet_oriented(task, seen)
                                   : meet_upright(task, seen);
    task.lanes = meet & ((1U << node.count) - 1);
  }
}

/// Corners along the rows of a matrix, about what is seen from the ray.
inline Corners turned_corners(const std::array<std::array<float, 4>, 3>& row,
                              const TriangleBlock& block, const std::array<float, 3>& seen) {
  Corners q;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const float* const from = block.corner[3 * corner].data();
    constexpr std::size_t kNext = TriangleBlock::kWidth;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& r = row[i];
      q[corner][i] = ((F8::load(from) * F8(r[0]) + F8::load(from + kNext) * F8(r[1])) +
                      F8::load(from + 2 * kNext) * F8(r[2])) +
                     F8(seen[i]);
    }
  }
  return q;
}

/// Corners about the point: along the ray, and across it.
inline Corners seen_corners(const RayNumbers& numbers, const TriangleBlock& block,
                            const std::array<float, 3>& seen) {
  if (numbers.rotated) {
    return turned_corners(numbers.row, block, seen);
  }
  Corners q;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t i = 0; i < 3; ++i) {
      q[corner][i] = F8::load(block.corner[3 * corner + numbers.axis[i]].data()) + F8(seen[i]);
    }
  }
  return q;
}

/// Twice the area between the point and an edge, seen along the ray: off by 2^-149 where products
/// underflow, which `area` below has room for.
inline F8 area_beside(const Three& a, const Three& b) {
  return a[1] * b[2] - a[2] * b[1];
}

/// Triangles as they look along the ray, whose corners are off by `error` and whose areas by
/// `area`: those that surely hold it inside, and those that surely do not hold it.
struct SeenAlong {
  SeenAlong(const Corners& q, float error, float area) {
    beside = {area_beside(q[0], q[1]), area_beside(q[1], q[2]), area_beside(q[2], q[0])};
    const F8 low = least(beside[0], beside[1], beside[2]);
    const F8 high = greatest(beside[0], beside[1], beside[2]);
    within = bits(low > F8(area)) | bits(F8(-area) > high);
    miss = bits(high > F8(area)) & bits(F8(-area) > low);
    for (std::size_t i = 1; i < 3; ++i) {
      miss |= bits((least(q[0][i], q[1][i], q[2][i]) > F8(error)) |
                   (F8(-error) > greatest(q[0][i], q[1][i], q[2][i])));
    }
  }

  Three beside;  ///< twice the areas between the ray and each edge
  std::uint32_t within;
  std::uint32_t miss;
};

inline void ray_block(RayBlockTask& task) {
  const RayNumbers& numbers = *task.numbers;
  const TriangleBlock& block = *task.block;
  const std::array<float, 3> seen = seen_from(numbers, *task.start, block.origin);
  const float size = block.l1_radius + (std::abs(seen[1]) + std::abs(seen[2]));
  const float error = size * 0x1p-21F + numbers.slack;
  const float along = (block.l1_radius + std::abs(seen[0])) * 0x1p-21F + numbers.slack;
  const float area = error * (size * 6 + error * 4) + 0x1p-140F;
  const Corners q = seen_corners(numbers, block, seen);
  const SeenAlong seen_along(q, error, area);
  std::uint32_t miss = seen_along.miss;
  const F8 sign(task.start->sign);
  const F8 a = q[0][0] * sign;
  const F8 b = q[1][0] * sign;
  const F8 c = q[2][0] * sign;
  miss |= bits(F8(-along) > greatest(a, b, c));
  const std::uint32_t ahead = bits(least(a, b, c) > F8(along));
  const std::uint32_t lanes = ((1U << block.count) - 1) & ~miss;
  task.cross = lanes & seen_along.within & ahead;
  task.open = lanes & ~task.cross;
}

inline void ray_blocks(RayBlockTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    ray_block(tasks[i]);
  }
}
