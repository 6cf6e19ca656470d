// AVX2: a register holds the centers of four boxes on one axis, and beside them their radii.
#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/kernels/instruction_set.h"

#if defined(__x86_64__)
#include "soms/query/detail/kernels/target.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

SOMS_TARGET_BEGIN("avx2,popcnt,bmi")

namespace soms::detail::avx2 {

namespace {

#include "soms/query/detail/kernels/lanes_x86.h"
#include "soms/query/detail/kernels/pack_x86.h"
//
#include "soms/query/detail/kernels/append_x86.h"
//
#include "soms/query/detail/kernels/lanes_avx.h"
//
#include "soms/query/detail/kernels/offset_avx.h"
//
#include "soms/query/detail/kernels/nodes.h"
//
#include "soms/query/detail/kernels/triangles.h"
//
#include "soms/query/detail/kernels/triangle_pairs.h"
//
#include "soms/query/detail/kernels/box_triangles.h"
//
constexpr std::size_t kDoubles = 4;
#include "soms/query/detail/kernels/lanes_double.h"
//
#include "soms/query/detail/kernels/triangle_pairs_double.h"
//
#include "soms/query/detail/kernels/near_nodes.h"
#include "soms/query/detail/kernels/near_triangles.h"
//
#include "soms/query/detail/kernels/parity.h"
//
#include "soms/query/detail/kernels/lines.h"
#include "soms/query/detail/kernels/point_bounds.h"

/// Pairs of lanes, rotations 0 and 1 and rotations 2 and 3, that some axis parts.
struct Apart {
  Apart() : first_(_mm256_setzero_ps()), second_(_mm256_setzero_ps()) {}

  /// One axis: `a` and `b` hold centers below and radii above.
  void add(__m256 a, __m256 b) {
    const __m256 swapped_a = _mm256_permute2f128_ps(a, a, 1);
    const __m256 swapped_b = _mm256_permute2f128_ps(b, b, 1);
    const __m256 minus_a = _mm256_sub_ps(a, swapped_a);
    const __m256 minus_b = _mm256_sub_ps(b, swapped_b);
    const __m256 plus_a = _mm256_add_ps(a, swapped_a);
    const __m256 plus_b = _mm256_add_ps(b, swapped_b);
    const __m256 lower_a = _mm256_permute2f128_ps(minus_a, minus_a, 0);
    const __m256 lower_b = _mm256_permute2f128_ps(minus_b, minus_b, 0);
    const __m256i turn01 = _mm256_setr_epi32(0, 1, 2, 3, 1, 2, 3, 0);
    const __m256i turn23 = _mm256_setr_epi32(2, 3, 0, 1, 3, 0, 1, 2);
    first_ = _mm256_or_ps(first_, beyond(lower_a, plus_a, _mm256_permutevar_ps(lower_b, turn01),
                                         _mm256_permutevar_ps(plus_b, turn01)));
    second_ = _mm256_or_ps(second_, beyond(lower_a, plus_a, _mm256_permutevar_ps(lower_b, turn23),
                                           _mm256_permutevar_ps(plus_b, turn23)));
  }

  [[nodiscard]] std::uint32_t bits() const {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(first_)) |
           static_cast<std::uint32_t>(_mm256_movemask_ps(second_)) << 8;
  }

 private:
  static __m256 beyond(__m256 lower_a, __m256 upper_a, __m256 lower_b, __m256 upper_b) {
    return _mm256_or_ps(_mm256_cmp_ps(lower_a, upper_b, _CMP_GT_OQ),
                        _mm256_cmp_ps(lower_b, upper_a, _CMP_GT_OQ));
  }

  __m256 first_;
  __m256 second_;
};

inline F8 beside(const std::array<float, 4>& low, const std::array<float, 4>& high) {
  return F8(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low.data())),
                                 _mm_load_ps(high.data()), 1));
}

inline F8 beside(float low, float high) {
  return F8(_mm256_insertf128_ps(_mm256_set1_ps(low), _mm_set1_ps(high), 1));
}

inline F8 sum(const Three& a, F8 m0, F8 m1, F8 m2) {
  return (a[0] * m0 + a[1] * m1) + a[2] * m2;
}

/// See nodes.h; the same sums in the same order.
inline std::uint32_t test_pair(const PoseNumbers& pose, const WideNode& x, const WideNode& y,
                               Centers* centers) {
  const __m128 shift = offset_of(pose, x.origin, y.origin).v;
  std::array<F4, 3> half_rotated;
  for (std::size_t i = 0; i < 3; ++i) {
    half_rotated[i] = (F4::load(x.row[0].data()) * F4(pose.n(i, 0)) +
                       F4::load(x.row[1].data()) * F4(pose.n(i, 1))) +
                      F4::load(x.row[2].data()) * F4(pose.n(i, 2));
  }
  half_rotated[0].v = _mm_insert_ps(half_rotated[0].v, shift, 0x30);
  half_rotated[1].v = _mm_insert_ps(half_rotated[1].v, shift, 0x70);
  half_rotated[2].v = _mm_insert_ps(half_rotated[2].v, shift, 0xb0);
  alignas(16) std::array<std::array<float, 4>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    const F4 seen = (half_rotated[0] * F4(y.row[0][i]) + half_rotated[1] * F4(y.row[1][i])) +
                    half_rotated[2] * F4(y.row[2][i]);
    seen.store(m[i].data());
  }
  const float margin = pose.relative * (x.l1_radius * pose.ratio + y.l1_radius) + pose.slack;
  const F8 sign = beside(0.0F, -0.0F);
  std::array<Three, 3> entry;  // beside its magnitude
  Three boxes_x;
  Three boxes_y;
  Three away;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      entry[i][j] = F8(_mm256_andnot_ps(sign.v, _mm256_set1_ps(m[i][j])));
    }
    boxes_x[i] = beside(x.center[i], x.half[i]) * F8(pose.ratio);
    boxes_y[i] = beside(y.center[i], y.half[i]);
    away[i] = boxes_y[i] - beside(m[i][3], 0.0F);
  }
  Apart apart;
  for (std::size_t i = 0; i < 3; ++i) {
    const F8 seen_x = sum(boxes_x, entry[i][0], entry[i][1], entry[i][2]) + beside(m[i][3], margin);
    const F8 seen_y = sum(away, entry[0][i], entry[1][i], entry[2][i]) + beside(0.0F, margin);
    apart.add(seen_x.v, boxes_y[i].v);
    apart.add(boxes_x[i].v, seen_y.v);
    if (centers != nullptr) {
      centers->x[i] = F4(_mm256_castps256_ps128(seen_x.v));
      centers->y[i] = F4(_mm256_castps256_ps128(boxes_y[i].v));
    }
  }
  return ~apart.bits();
}

void test_nodes(NodeTask* tasks, std::size_t count) {
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

}  // namespace

const Kernels& kernels() {
  static constexpr Kernels kTable{"avx2",          test_nodes,      test_larger, append,
                                  test_slabs,      test_boxes,      meet_box,    judge,
                                  judge_in_double, bound_nodes,     near_boxes,  near_pairs,
                                  bound_boxes,     bound_triangles, ray_nodes,   ray_blocks,
                                  line_descents,   line_node,       line_block};
  return kTable;
}

}  // namespace soms::detail::avx2

SOMS_TARGET_END
#endif
