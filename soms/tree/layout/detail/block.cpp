#include "soms/tree/layout/detail/block.h"

#include <cstring>

namespace soms::layout {

namespace {

// Everything is inlined into make_block, which is compiled for the instructions that every
// processor has, for AVX2 and for AVX-512. All give the same bytes: each lane is a double, and
// nothing is fused or reordered.

constexpr std::size_t kLanes = TriangleBlock::kWidth;

/// A number for each triangle.
using Row [[gnu::vector_size(64)]] = double;
using Floats [[gnu::vector_size(32)]] = float;

/// Row 3 * corner + axis.
using Rows = std::array<Row, 9>;

constexpr Row kLane = {0, 1, 2, 3, 4, 5, 6, 7};

[[gnu::always_inline]] inline void keep_less(Row& v, const Row& other) {
  v = other < v ? other : v;
}

[[gnu::always_inline]] inline void keep_greater(Row& v, const Row& other) {
  v = other > v ? other : v;
}

struct Range {
  double lower;
  double upper;
};

/// Least and greatest of three rows.
[[gnu::always_inline]] inline Range range(const Row& a, const Row& b, const Row& c) {
  Row lower = a;
  Row upper = a;
  keep_less(lower, b);
  keep_less(lower, c);
  keep_greater(upper, b);
  keep_greater(upper, c);
  keep_less(lower, __builtin_shufflevector(lower, lower, 4, 5, 6, 7, 0, 1, 2, 3));
  keep_less(lower, __builtin_shufflevector(lower, lower, 2, 3, 0, 1, 6, 7, 4, 5));
  keep_less(lower, __builtin_shufflevector(lower, lower, 1, 0, 3, 2, 5, 4, 7, 6));
  keep_greater(upper, __builtin_shufflevector(upper, upper, 4, 5, 6, 7, 0, 1, 2, 3));
  keep_greater(upper, __builtin_shufflevector(upper, upper, 2, 3, 0, 1, 6, 7, 4, 5));
  keep_greater(upper, __builtin_shufflevector(upper, upper, 1, 0, 3, 2, 5, 4, 7, 6));
  return {lower[0], upper[0]};
}

/// Corners about the tree's origin; lanes not in use repeat the last triangle.
[[gnu::always_inline]] inline void gather(const Mesh& mesh, std::span<const TriangleId> ids,
                                          const Vec3& origin, Rows& rows, TriangleBlock& block) {
  alignas(64) std::array<std::array<double, kLanes>, 9> corner;
  for (std::size_t k = 0; k < kLanes; ++k) {
    const TriangleId id = ids[std::min(k, ids.size() - 1)];
    block.id[k] = id;
    const auto& corners = mesh.triangles[id];
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& v = mesh.vertices[corners[c]];
      corner[3 * c][k] = v.x;
      corner[3 * c + 1][k] = v.y;
      corner[3 * c + 2][k] = v.z;
    }
  }
  for (std::size_t row = 0; row < 9; ++row) {
    std::memcpy(&rows[row], corner[row].data(), sizeof(Row));
    rows[row] -= origin[row % 3];
  }
}

/// Puts the block's origin in the middle and takes corners about it, in units of the layout;
/// returns the farthest on each axis.
[[gnu::always_inline]] inline std::array<double, 3> center(const Frame& frame, Rows& rows,
                                                           TriangleBlock& block) {
  std::array<double, 3> far = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lower, upper] = range(rows[axis], rows[3 + axis], rows[6 + axis]);
    const double middle = 0.5 * (lower + upper);
    block.origin[axis] = middle;
    far[axis] = std::max(upper - middle, middle - lower) * frame.scale;
    for (std::size_t row = axis; row < 9; row += 3) {
      rows[row] = (rows[row] - middle) * frame.scale;
      const Floats rounded = __builtin_convertvector(rows[row], Floats);
      std::memcpy(block.corner[row].data(), &rounded, sizeof rounded);
    }
  }
  return far;
}

/// Sum of the lanes in use.
[[gnu::always_inline]] inline double sum(const Row& of, double count) {
  Row v = kLane < count ? of : Row{};
  v += __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3);
  v += __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5);
  return v[0] + v[1];
}

template <std::size_t Axis>
[[gnu::always_inline]] inline void add_axis(const Rows& rows, double count, Moments& m) {
  constexpr std::size_t kNext = (Axis + 1) % 3;
  const Row a = rows[Axis];
  const Row b = rows[3 + Axis];
  const Row c = rows[6 + Axis];
  const Row p = rows[kNext];
  const Row q = rows[3 + kNext];
  const Row r = rows[6 + kNext];
  const Row normal = (b - a) * (r - p) - (q - p) * (c - a);
  m.sum[Axis] = sum((a + b) + c, count);
  m.square[Axis] = sum((a * a + b * b) + c * c, count);
  m.product[Axis] = sum((a * p + b * q) + c * r, count);
  m.normal[(Axis + 2) % 3] = sum(normal, count);
  m.area += sum(normal < 0 ? -normal : normal, count);
}

[[gnu::always_inline]] inline Moments moments_of(const Rows& rows, std::size_t count) {
  Moments m;
  m.points = static_cast<double>(3 * count);
  const auto lanes = static_cast<double>(count);
  add_axis<0>(rows, lanes, m);
  add_axis<1>(rows, lanes, m);
  add_axis<2>(rows, lanes, m);
  return m;
}

/// Mean normal of the triangles, and the interval of the corners on it. Coordinates are in doubt by
/// `give`, which is more than the products with the normal, of 1-norm below 1.74, can add.
[[gnu::always_inline]] inline void store_slab(const std::array<double, 3>& sum, const Rows& rows,
                                              double give, TriangleBlock& block) {
  // Divided by its largest entry first, so that no square underflows.
  const double most = std::max({std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2])});
  const Vec3 n = most > 0 ? Vec3{sum[0] / most, sum[1] / most, sum[2] / most} : Vec3{0, 0, 1};
  const double length = std::sqrt(dot(n, n));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.normal[axis] = static_cast<float>(n[axis] / length);
  }
  const double x = block.normal[0];
  const double y = block.normal[1];
  const double z = block.normal[2];
  const auto [lower, upper] =
      range((x * rows[0] + y * rows[1]) + z * rows[2], (x * rows[3] + y * rows[4]) + z * rows[5],
            (x * rows[6] + y * rows[7]) + z * rows[8]);
  block.lower = -rounded_up(3 * give - lower);
  block.upper = rounded_up(3 * give + upper);
}

[[gnu::always_inline]] inline Moments make(const Mesh& mesh, std::span<const TriangleId> ids,
                                           const Frame& frame, TriangleBlock& block) {
  Rows rows;
  gather(mesh, ids, frame.origin, rows, block);
  const std::array<double, 3> far = center(frame, rows, block);
  const Moments moments = moments_of(rows, ids.size());
  block.count = static_cast<std::uint32_t>(ids.size()) & 0xf;
  const double give = frame.doubt((far[0] + far[1]) + far[2], false);
  double l1_radius = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.own_half[axis] = rounded_up(far[axis] + give);
    l1_radius += static_cast<double>(block.own_half[axis]);
  }
  block.l1_radius = rounded_up(l1_radius * (1 + 0x1p-50));  // the sum of three had two roundings
  store_slab(moments.normal, rows, give, block);
  return moments;
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] Moments make_by_avx2(const Mesh& mesh, std::span<const TriangleId> ids,
                                             const Frame& frame, TriangleBlock& block) {
  return make(mesh, ids, frame, block);
}

[[gnu::target("avx512f,avx512vl,avx512dq")]] Moments make_by_avx512(const Mesh& mesh,
                                                                    std::span<const TriangleId> ids,
                                                                    const Frame& frame,
                                                                    TriangleBlock& block) {
  return make(mesh, ids, frame, block);
}
#endif

}  // namespace

Moments make_block_plainly(const Mesh& mesh, std::span<const TriangleId> ids, const Frame& frame,
                           TriangleBlock& block) {
  return make(mesh, ids, frame, block);
}

Moments make_block(const Mesh& mesh, std::span<const TriangleId> ids, const Frame& frame,
                   TriangleBlock& block) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq")) {
    return make_by_avx512(mesh, ids, frame, block);
  }
  if (__builtin_cpu_supports("avx2")) {
    return make_by_avx2(mesh, ids, frame, block);
  }
#endif
  return make_block_plainly(mesh, ids, frame, block);
}

}  // namespace soms::layout
