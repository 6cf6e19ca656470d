#include "soms/tree/layout/detail/block.h"

#include "soms/tree/layout/detail/double_lanes.h"

#include <cstring>

namespace soms::layout {

namespace {

// Everything is inlined into make_block, which is compiled for the instructions that every
// processor has, for AVX2 and for AVX-512. All give the same bytes: each lane is a double, and
// nothing is fused or reordered.

constexpr std::size_t kLanes = TriangleBlock::kWidth;

using Floats [[gnu::vector_size(16)]] = float;

/// A number for each triangle. Compilers keep halves in registers; of vectors as long as a row they
/// put the halves into memory and take them out number by number wherever lanes change places.
struct Row {
  D4 first;
  D4 last;
};

/// Row 3 * corner + axis.
using Rows = std::array<Row, 9>;

[[gnu::always_inline]] inline Row operator+(const Row& a, const Row& b) {
  return {a.first + b.first, a.last + b.last};
}

[[gnu::always_inline]] inline Row operator-(const Row& a, const Row& b) {
  return {a.first - b.first, a.last - b.last};
}

[[gnu::always_inline]] inline Row operator*(const Row& a, const Row& b) {
  return {a.first * b.first, a.last * b.last};
}

/// Rows are never assigned as a whole: GCC moves them by 16 bytes, and waits where it reads 32.
[[gnu::always_inline]] inline void set(Row& to, const Row& from) {
  to.first = from.first;
  to.last = from.last;
}

[[gnu::always_inline]] inline Row splat(double x) {
  const D4 v = all_lanes(x);
  return {v, v};
}

struct Range {
  double lower;
  double upper;
};

/// Least and greatest of three rows.
[[gnu::always_inline]] inline Range range(const Row& a, const Row& b, const Row& c) {
  const D4 low =
      lesser(lesser(lesser(a.first, b.first), c.first), lesser(lesser(a.last, b.last), c.last));
  const D4 high = greater(greater(greater(a.first, b.first), c.first),
                          greater(greater(a.last, b.last), c.last));
  const double low_even = low[2] < low[0] ? low[2] : low[0];
  const double low_odd = low[3] < low[1] ? low[3] : low[1];
  const double high_even = high[2] > high[0] ? high[2] : high[0];
  const double high_odd = high[3] > high[1] ? high[3] : high[1];
  return {low_odd < low_even ? low_odd : low_even, high_odd > high_even ? high_odd : high_even};
}

/// Corners; lanes not in use repeat the last triangle.
[[gnu::always_inline]] inline void read_corners(const MeshView& mesh,
                                                std::span<const TriangleId> ids, Rows& rows,
                                                TriangleBlock& block) {
  std::array<const std::array<std::uint32_t, 3>*, kLanes> corners;
  for (std::size_t k = 0; k < kLanes; ++k) {
    block.id[k] = ids[std::min(k, ids.size() - 1)];
    corners[k] = &mesh.triangles[block.id[k]];
  }
  for (std::size_t c = 0; c < 3; ++c) {
    std::array<const Vec3*, kLanes> at;
    for (std::size_t k = 0; k < kLanes; ++k) {
      at[k] = &mesh.vertices[(*corners[k])[c]];
    }
    const auto row = [&](double Vec3::*axis) {
      const D4 first = {at[0]->*axis, at[1]->*axis, at[2]->*axis, at[3]->*axis};
      const D4 last = {at[4]->*axis, at[5]->*axis, at[6]->*axis, at[7]->*axis};
      return Row{first, last};
    };
    set(rows[3 * c], row(&Vec3::x));
    set(rows[3 * c + 1], row(&Vec3::y));
    set(rows[3 * c + 2], row(&Vec3::z));
  }
}

/// Puts the block's origin in the middle and takes corners about it, in units of the layout;
/// returns the farthest on each axis. Rounding keeps the order of what a place is subtracted from,
/// so the least is the same before and after.
[[gnu::always_inline]] inline std::array<double, 3> center(const Frame& frame, Rows& rows,
                                                           TriangleBlock& block, Box& bounds) {
  std::array<double, 3> far = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] = range(rows[axis], rows[3 + axis], rows[6 + axis]);
    bounds.lower[axis] = least;
    bounds.upper[axis] = most;
    const double origin = frame.origin[axis];
    const double lower = least - origin;
    const double upper = most - origin;
    const double middle = 0.5 * (lower + upper);
    block.origin[axis] = middle;
    far[axis] = std::max(upper - middle, middle - lower) * frame.scale;
    for (std::size_t row = axis; row < 9; row += 3) {
      set(rows[row], ((rows[row] - splat(origin)) - splat(middle)) * splat(frame.scale));
      const Floats first = __builtin_convertvector(rows[row].first, Floats);
      const Floats last = __builtin_convertvector(rows[row].last, Floats);
      std::memcpy(block.corner[row].data(), &first, sizeof first);
      std::memcpy(block.corner[row].data() + kLanes / 2, &last, sizeof last);
    }
  }
  return far;
}

/// All bits of the lanes in use.
struct Mask {
  using Bits [[gnu::vector_size(32)]] = std::int64_t;
  Bits first;
  Bits last;
};

[[gnu::always_inline]] inline Mask mask_of(std::size_t count) {
  const auto n = static_cast<std::int64_t>(count);
  const Mask::Bits all = {n, n, n, n};
  constexpr Mask::Bits kFirst = {0, 1, 2, 3};
  constexpr Mask::Bits kLast = {4, 5, 6, 7};
  return {kFirst < all, kLast < all};
}

/// Lanes in use, those of the second half added to those of the first.
[[gnu::always_inline]] inline D4 folded(const Row& v, const Mask& mask) {
  return (mask.first ? v.first : D4{}) + (mask.last ? v.last : D4{});
}

/// Sums of four halves: lanes 0 and 2, 1 and 3, then both.
[[gnu::always_inline]] inline D4 sums(const D4& a, const D4& b, const D4& c, const D4& d) {
  const D4 ab =
      __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
  const D4 cd =
      __builtin_shufflevector(c, d, 0, 1, 4, 5) + __builtin_shufflevector(c, d, 2, 3, 6, 7);
  const D4 all =
      __builtin_shufflevector(ab, cd, 0, 4, 2, 6) + __builtin_shufflevector(ab, cd, 1, 5, 3, 7);
  return __builtin_shufflevector(all, all, 0, 2, 1, 3);
}

template <std::size_t Axis>
[[gnu::always_inline]] inline void add_axis(const Rows& rows, const Mask& mask, Moments& m) {
  constexpr std::size_t kNext = (Axis + 1) % 3;
  const Row& a = rows[Axis];
  const Row& b = rows[3 + Axis];
  const Row& c = rows[6 + Axis];
  const Row& p = rows[kNext];
  const Row& q = rows[3 + kNext];
  const Row& r = rows[6 + kNext];
  const Row normal = (b - a) * (r - p) - (q - p) * (c - a);
  const Row size = {normal.first < 0 ? -normal.first : normal.first,
                    normal.last < 0 ? -normal.last : normal.last};
  const D4 of_four = sums(folded((a + b) + c, mask), folded((a * a + b * b) + c * c, mask),
                          folded((a * p + b * q) + c * r, mask), folded(normal, mask));
  m.sum[Axis] = of_four[0];
  m.square[Axis] = of_four[1];
  m.product[Axis] = of_four[2];
  m.normal[(Axis + 2) % 3] = of_four[3];
  const D4 area = folded(size, mask);
  m.area += (area[0] + area[2]) + (area[1] + area[3]);
}

[[gnu::always_inline]] inline Moments moments_of(const Rows& rows, std::size_t count) {
  Moments m;
  m.points = static_cast<double>(3 * count);
  const Mask mask = mask_of(count);
  add_axis<0>(rows, mask, m);
  add_axis<1>(rows, mask, m);
  add_axis<2>(rows, mask, m);
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
  const Row x = splat(block.normal[0]);
  const Row y = splat(block.normal[1]);
  const Row z = splat(block.normal[2]);
  const auto [lower, upper] =
      range((x * rows[0] + y * rows[1]) + z * rows[2], (x * rows[3] + y * rows[4]) + z * rows[5],
            (x * rows[6] + y * rows[7]) + z * rows[8]);
  block.lower = -rounded_up(3 * give - lower);
  block.upper = rounded_up(3 * give + upper);
}

[[gnu::always_inline]] inline BlockContent make(const MeshView& mesh,
                                                std::span<const TriangleId> ids, const Frame& frame,
                                                TriangleBlock& block) {
  Rows rows;
  BlockContent content;
  read_corners(mesh, ids, rows, block);
  const std::array<double, 3> far = center(frame, rows, block, content.bounds);
  content.moments = moments_of(rows, ids.size());
  block.count = static_cast<std::uint32_t>(ids.size()) & 0xf;
  const double give = frame.doubt((far[0] + far[1]) + far[2], false);
  double l1_radius = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    block.own_half[axis] = rounded_up(far[axis] + give);
    l1_radius += static_cast<double>(block.own_half[axis]);
  }
  block.l1_radius = rounded_up(l1_radius * (1 + 0x1p-50));  // the sum of three had two roundings
  store_slab(content.moments.normal, rows, give, block);
  return content;
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] BlockContent make_by_avx2(const MeshView& mesh,
                                                  std::span<const TriangleId> ids,
                                                  const Frame& frame, TriangleBlock& block) {
  return make(mesh, ids, frame, block);
}

[[gnu::target("avx512f,avx512vl,avx512dq")]] BlockContent make_by_avx512(
    const MeshView& mesh, std::span<const TriangleId> ids, const Frame& frame,
    TriangleBlock& block) {
  return make(mesh, ids, frame, block);
}
#endif

}  // namespace

BlockContent make_block_plainly(const MeshView& mesh, std::span<const TriangleId> ids,
                                const Frame& frame, TriangleBlock& block) {
  return make(mesh, ids, frame, block);
}

BlockContent make_block(const MeshView& mesh, std::span<const TriangleId> ids, const Frame& frame,
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
