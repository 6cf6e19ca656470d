// AVX-512: a register holds three axes times four boxes, axis i in its 128-bit block i.
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

#if !defined(__clang__)
// The compiler's own header sets registers to themselves to leave them undefined.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
// Without optimization its gather is a macro that passes a full mask as a signed number.
#pragma GCC diagnostic ignored "-Wsign-conversion"
#endif

SOMS_TARGET_BEGIN("avx512f,avx512vl,avx512dq,avx512bw,avx2,bmi,bmi2,popcnt")

namespace soms::detail::avx512 {

namespace {

#include "soms/query/detail/kernels/lanes_x86.h"
//
#include "soms/query/detail/kernels/lanes_avx512.h"
#include "soms/query/detail/kernels/lanes_wide_avx512.h"
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
constexpr std::size_t kDoubles = 8;
#include "soms/query/detail/kernels/lanes_double.h"
//
#include "soms/query/detail/kernels/triangle_pairs_double.h"
//
#include "soms/query/detail/kernels/relative_poses.h"
//
#include "soms/query/detail/kernels/pose_checks.h"
//
#include "soms/query/detail/kernels/neighbors.h"
//
#include "soms/query/detail/kernels/near_nodes.h"
#include "soms/query/detail/kernels/near_triangles.h"
//
#include "soms/query/detail/kernels/parity.h"
//
#include "soms/query/detail/kernels/lines.h"
#include "soms/query/detail/kernels/point_bounds.h"

inline __m512 four(const std::array<float, 4>& from) {
  return _mm512_broadcast_f32x4(_mm_load_ps(from.data()));
}

inline __m512 product(__m512 a, __m512 b) {
  return _mm512_mul_ps(a, b);
}

/// `(a b + c d) + e f`.
inline __m512 sum(__m512 a, __m512 b, __m512 c, __m512 d, __m512 e, __m512 f) {
  return _mm512_add_ps(_mm512_add_ps(product(a, b), product(c, d)), product(e, f));
}

/// Block i takes lane `4 i + k` everywhere.
template <int K>
inline __m512 spread_rows(__m512 m) {
  return _mm512_permute_ps(m, K * 0x55);
}

/// Block j takes lane `4 I + j` everywhere.
template <int I>
inline __m512 spread_columns(__m512 m) {
  const __m512i from =
      _mm512_setr_epi32(4 * I, 4 * I, 4 * I, 4 * I, 4 * I + 1, 4 * I + 1, 4 * I + 1, 4 * I + 1,
                        4 * I + 2, 4 * I + 2, 4 * I + 2, 4 * I + 2, 0, 0, 0, 0);
  return _mm512_permutexvar_ps(from, m);
}

/// Everywhere what one lane holds.
template <int Lane>
inline __m512 spread(__m512 m) {
  return _mm512_permutexvar_ps(_mm512_set1_epi32(Lane), m);
}

/// Lane k of each block takes what lane (k + R) mod 4 held.
template <int R>
inline __m512 turn(__m512 m) {
  constexpr int kFrom = (R & 3) | ((R + 1) & 3) << 2 | ((R + 2) & 3) << 4 | ((R + 3) & 3) << 6;
  return _mm512_permute_ps(m, kFrom);
}

/// Intervals of four boxes on three axes.
struct Spans {
  Spans(__m512 center, __m512 radius)
      : lower(_mm512_sub_ps(center, radius)), upper(_mm512_add_ps(center, radius)) {}

  __m512 lower;
  __m512 upper;
};

/// Bit 4 i + k unless axis i parts lane k of `a` from lane (k + R) mod 4 of `b`, or of `c` and `d`.
template <int R>
inline std::uint64_t meet(const Spans& a, const Spans& b, const Spans& c, const Spans& d) {
  __mmask16 q = 0x0fff;
  q = _mm512_mask_cmp_ps_mask(q, a.lower, turn<R>(b.upper), _CMP_NGT_UQ);
  q = _mm512_mask_cmp_ps_mask(q, turn<R>(b.lower), a.upper, _CMP_NGT_UQ);
  q = _mm512_mask_cmp_ps_mask(q, c.lower, turn<R>(d.upper), _CMP_NGT_UQ);
  q = _mm512_mask_cmp_ps_mask(q, turn<R>(d.lower), c.upper, _CMP_NGT_UQ);
  return q;
}

/// A node's numbers in the units of the other's layout: mostly they are already.
template <bool Scaled>
inline __m512 scaled(__m512 v, __m512 ratio) {
  return Scaled ? product(v, ratio) : v;
}

/// Squares of what lies between centers on each axis, one rotation in each.
struct Squares {
  __m512 r0;
  __m512 r1;
  __m512 r2;
  __m512 r3;
};

template <int R>
inline __m512 square(__m512 x, __m512 y) {
  const __m512 between = _mm512_sub_ps(x, turn<R>(y));
  return _mm512_maskz_mul_ps(0x0fff, between, between);
}

/// Axes 0 and 2 of two rotations, and axis 1 of them.
inline __m512 two_axes(__m512 a, __m512 b) {
  return _mm512_add_ps(_mm512_shuffle_f32x4(a, b, 0x44), _mm512_shuffle_f32x4(a, b, 0xee));
}

/// See `below_nearest` of nodes.h.
inline std::uint32_t below_nearest(const Squares& s, std::uint32_t pairs) {
  const __m512 low = two_axes(s.r0, s.r1);
  const __m512 high = two_axes(s.r2, s.r3);
  const __m512 distance =
      _mm512_add_ps(_mm512_shuffle_f32x4(low, high, 0x88), _mm512_shuffle_f32x4(low, high, 0xdd));
  const auto set = static_cast<__mmask16>(pairs);
  const __m512 candidates =
      _mm512_mask_mov_ps(_mm512_set1_ps(std::numeric_limits<float>::infinity()), set, distance);
  __m512 least = _mm512_min_ps(candidates, _mm512_shuffle_f32x4(candidates, candidates, 0x4e));
  least = _mm512_min_ps(least, _mm512_shuffle_f32x4(least, least, 0xb1));
  least = _mm512_min_ps(least, _mm512_permute_ps(least, 0x4e));
  least = _mm512_min_ps(least, _mm512_permute_ps(least, 0xb1));
  const std::uint32_t nearest = _mm512_mask_cmp_ps_mask(set, distance, least, _CMP_EQ_OQ);
  return (nearest & (0 - nearest)) - 1;
}

/// M of relative_pose.h, row i in block i; the offset rides in the fourth lanes. Products with axes
/// that are the mesh's would change nothing: most large nodes have those.
template <bool Oriented>
inline __m512 seen_matrix(const PoseNumbers& pose, const WideNode& x, const WideNode& y) {
  const __m128 shift = offset_of(pose, x.origin, y.origin).v;
  __m512 m = _mm512_load_ps(pose.rows.data());
  if (Oriented) {
    m = sum(four(x.row[0]), spread_rows<0>(m), four(x.row[1]), spread_rows<1>(m), four(x.row[2]),
            spread_rows<2>(m));
  }
  m = _mm512_mask_permutexvar_ps(m, 0x0888,
                                 _mm512_setr_epi32(0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0),
                                 _mm512_castps128_ps512(shift));
  if (Oriented) {
    const __m512 rows_y = _mm512_loadu_ps(y.row[0].data());
    m = sum(_mm512_shuffle_f32x4(m, m, 0), spread_columns<0>(rows_y),
            _mm512_shuffle_f32x4(m, m, 0x55), spread_columns<1>(rows_y),
            _mm512_shuffle_f32x4(m, m, 0xaa), spread_columns<2>(rows_y));
  }
  return m;
}

template <bool Scaled>
inline __m512 margin_of(const PoseNumbers& pose, const WideNode& x, const WideNode& y) {
  const __m512 ratio = _mm512_set1_ps(pose.ratio);
  return _mm512_add_ps(product(_mm512_set1_ps(pose.relative),
                               _mm512_add_ps(scaled<Scaled>(_mm512_set1_ps(x.l1_radius), ratio),
                                             _mm512_set1_ps(y.l1_radius))),
                       _mm512_set1_ps(pose.slack));
}

/// Pairs that no axis parts, of boxes as both nodes see them; bits as NodeTask::pairs.
inline std::uint32_t pairs_that_meet(const Spans& x_in_y, const Spans& y_in_y, const Spans& x_in_x,
                                     const Spans& y_in_x) {
  const std::uint64_t all =
      meet<0>(x_in_y, y_in_y, x_in_x, y_in_x) | meet<1>(x_in_y, y_in_y, x_in_x, y_in_x) << 16 |
      meet<2>(x_in_y, y_in_y, x_in_x, y_in_x) << 32 | meet<3>(x_in_y, y_in_y, x_in_x, y_in_x) << 48;
  return static_cast<std::uint32_t>(_pext_u64(all & all >> 4 & all >> 8, 0x000f000f000f000fULL));
}

/// See nodes.h; the same sums in the same order.
template <bool Scaled, bool Oriented, bool Ordered>
inline void test_task(NodeTask& task) {
  const WideNode& x = *task.x;
  const WideNode& y = *task.y;
  const __m512 m = seen_matrix<Oriented>(*task.pose, x, y);
  const __m512 a = _mm512_abs_ps(m);
  const __m512 ratio = _mm512_set1_ps(task.pose->ratio);
  const __m512 margin = margin_of<Scaled>(*task.pose, x, y);
  const __m512 seen_x =
      _mm512_add_ps(sum(scaled<Scaled>(four(x.center[0]), ratio), spread_rows<0>(m),
                        scaled<Scaled>(four(x.center[1]), ratio), spread_rows<1>(m),
                        scaled<Scaled>(four(x.center[2]), ratio), spread_rows<2>(m)),
                    spread_rows<3>(m));
  const __m512 radius_x =
      _mm512_add_ps(sum(scaled<Scaled>(four(x.half[0]), ratio), spread_rows<0>(a),
                        scaled<Scaled>(four(x.half[1]), ratio), spread_rows<1>(a),
                        scaled<Scaled>(four(x.half[2]), ratio), spread_rows<2>(a)),
                    margin);
  const __m512 seen_y = sum(_mm512_sub_ps(four(y.center[0]), spread<3>(m)), spread_columns<0>(m),
                            _mm512_sub_ps(four(y.center[1]), spread<7>(m)), spread_columns<1>(m),
                            _mm512_sub_ps(four(y.center[2]), spread<11>(m)), spread_columns<2>(m));
  const __m512 radius_y =
      _mm512_add_ps(sum(four(y.half[0]), spread_columns<0>(a), four(y.half[1]),
                        spread_columns<1>(a), four(y.half[2]), spread_columns<2>(a)),
                    margin);
  const __m512 center_y = _mm512_loadu_ps(y.center[0].data());
  // Fourth blocks hold whatever follows in a node; their bits are left out.
  const Spans x_in_y(seen_x, radius_x);
  const Spans y_in_y(center_y, _mm512_loadu_ps(y.half[0].data()));
  const Spans x_in_x(scaled<Scaled>(_mm512_loadu_ps(x.center[0].data()), ratio),
                     scaled<Scaled>(_mm512_loadu_ps(x.half[0].data()), ratio));
  const Spans y_in_x(seen_y, radius_y);
  task.pairs &= pairs_that_meet(x_in_y, y_in_y, x_in_x, y_in_x);
  if (Ordered) {
    task.below = below_nearest({square<0>(seen_x, center_y), square<1>(seen_x, center_y),
                                square<2>(seen_x, center_y), square<3>(seen_x, center_y)},
                               task.node_ids());
  }
}

template <bool Scaled, bool Oriented>
inline void test_ordered(NodeTask& task) {
  if (task.order != 0) {
    test_task<Scaled, Oriented, true>(task);
  } else {
    test_task<Scaled, Oriented, false>(task);
  }
}

template <bool Scaled>
void test_each(NodeTask* tasks, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if ((tasks[i].x->oriented | tasks[i].y->oriented) != 0) {
      test_ordered<Scaled, true>(tasks[i]);
    } else {
      test_ordered<Scaled, false>(tasks[i]);
    }
  }
}

void test_nodes(NodeTask* tasks, std::size_t count) {
  if (count != 0) {
    (tasks[0].pose->ratio == 1 ? test_each<false> : test_each<true>)(tasks, count);
  }
}

/// Appends pairs of lanes, rotation by rotation; returns how many.
inline std::size_t put_all(std::uint32_t pairs, __m128i x, __m128i y, std::uint32_t* to_x,
                           std::uint32_t* to_y) {
  const __m512i from = _mm512_setr_epi32(0, 1, 2, 3, 1, 2, 3, 0, 2, 3, 0, 1, 3, 0, 1, 2);
  const auto set = static_cast<__mmask16>(pairs);
  _mm512_storeu_si512(to_x, _mm512_maskz_compress_epi32(set, _mm512_broadcast_i32x4(x)));
  _mm512_storeu_si512(to_y, _mm512_maskz_compress_epi32(
                                set, _mm512_permutexvar_epi32(from, _mm512_castsi128_si512(y))));
  return static_cast<std::size_t>(std::popcount(pairs));
}

#include "soms/query/detail/kernels/append_x86.h"

}  // namespace

const Kernels& kernels() {
  static constexpr Kernels kTable{
      "avx512",      test_nodes,      test_larger,     append,      test_slabs,    test_boxes,
      meet_box,      judge,           judge_in_double, bound_nodes, near_boxes,    near_pairs,
      bound_boxes,   bound_triangles, ray_nodes,       ray_blocks,  passing_poses, apart_at_corner,
      apart_at_edge, relative_poses,  line_descents,   line_node,   line_block};
  return kTable;
}

}  // namespace soms::detail::avx512

SOMS_TARGET_END
#endif
