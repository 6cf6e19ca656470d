// AVX2: a register holds numbers of four boxes of x on one axis, and above them those of four boxes
// of y.
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
#include "soms/query/detail/kernels/pack_avx.h"
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

/// `low` four times, and `high` four times above.
inline F8 beside(float low, float high) {
  return F8(_mm256_insertf128_ps(_mm256_set1_ps(low), _mm_set1_ps(high), 1));
}

inline F8 beside(const std::array<float, 4>& low, const std::array<float, 4>& high) {
  return F8(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low.data())),
                                 _mm_load_ps(high.data()), 1));
}

inline F8 magnitude(F8 a) {
  return F8(_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v));
}

inline F8 halves_swapped(F8 a) {
  return F8(_mm256_permute2f128_ps(a.v, a.v, 1));
}

/// M and d of relative_pose.h for a pair of nodes, and the margin.
struct SeenNodes {
  alignas(16) std::array<std::array<float, 4>, 3> m;  ///< rows; d is the fourth column
  float margin;
};

inline void see(const NodeTask& task, SeenNodes& seen) {
  const PoseNumbers& pose = *task.pose;
  const WideNode& x = *task.x;
  const WideNode& y = *task.y;
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
  for (std::size_t i = 0; i < 3; ++i) {
    const F4 row = (half_rotated[0] * F4(y.row[0][i]) + half_rotated[1] * F4(y.row[1][i])) +
                   half_rotated[2] * F4(y.row[2][i]);
    row.store(seen.m[i].data());
  }
  seen.margin = pose.relative * (x.l1_radius * pose.ratio + y.l1_radius) + pose.slack;
}

/// Ends of intervals.
struct Ends {
  Ends(F8 center, F8 half) : lower(center - half), upper(center + half) {}

  F8 lower;
  F8 upper;
};

/// Pairs of lanes that some axis parts, by rotations: axes of y below, by the lanes of x, and axes
/// of x above, by those of y.
class Apart {
 public:
  Apart() {
    for (M8& apart : apart_) {
      apart.v = _mm256_setzero_ps();
    }
  }

  /// `seen` are boxes of x and boxes of y along the other's axis; `own` those of y and of x.
  void add(const Ends& seen, const Ends& own) {
    apart_[0] = apart_[0] | beyond(seen, own.lower, own.upper);
    apart_[1] = apart_[1] | beyond(seen, turned<1>(own.lower), turned<1>(own.upper));
    apart_[2] = apart_[2] | beyond(seen, turned<2>(own.lower), turned<2>(own.upper));
    apart_[3] = apart_[3] | beyond(seen, turned<3>(own.lower), turned<3>(own.upper));
  }

  [[nodiscard]] std::uint32_t bits() const {
    const __m256i bytes = _mm256_packs_epi16(words(apart_[0], by_lanes_of_x<1>()),
                                             words(by_lanes_of_x<2>(), by_lanes_of_x<3>()));
    const auto all = static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes));
    return (all | all >> 16) & 0xffff;
  }

 private:
  static __m256i words(M8 a, M8 b) {
    return _mm256_packs_epi32(_mm256_castps_si256(a.v), _mm256_castps_si256(b.v));
  }

  /// Lane k takes what lane (k + R) mod 4 held, and above lane (k - R) mod 4.
  template <int R>
  static F8 turned(F8 a) {
    return F8(_mm256_permutevar_ps(
        a.v, _mm256_setr_epi32(R, (R + 1) & 3, (R + 2) & 3, (R + 3) & 3, (4 - R) & 3, (5 - R) & 3,
                               (6 - R) & 3, (7 - R) & 3)));
  }

  static M8 beyond(const Ends& seen, F8 lower, F8 upper) {
    return (seen.lower > upper) | (lower > seen.upper);
  }

  template <int R>
  [[nodiscard]] M8 by_lanes_of_x() const {
    return {_mm256_permutevar_ps(
        apart_[R].v, _mm256_setr_epi32(0, 1, 2, 3, R, (R + 1) & 3, (R + 2) & 3, (R + 3) & 3))};
  }

  std::array<M8, 4> apart_;
};

/// See nodes.h; the same sums in the same order. Boxes of x lie below those of y.
inline std::uint32_t test_pair(const NodeTask& task, const SeenNodes& seen, Centers* centers) {
  const WideNode& x = *task.x;
  const WideNode& y = *task.y;
  const auto& m = seen.m;
  const F8 ratio = beside(task.pose->ratio, 1);
  const F8 margin(seen.margin);
  Three center;
  Three half;
  Three away;
  std::array<Three, 3> entry;
  for (std::size_t i = 0; i < 3; ++i) {
    center[i] = beside(x.center[i], y.center[i]) * ratio;
    half[i] = beside(x.half[i], y.half[i]) * ratio;
    away[i] = center[i] - beside(0, m[i][3]);
    entry[i][i] = F8(m[i][i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const F8 below(m[i][j]);
      const F8 above(m[j][i]);
      entry[i][j] = F8(_mm256_blend_ps(below.v, above.v, 0xf0));
      entry[j][i] = F8(_mm256_blend_ps(above.v, below.v, 0xf0));
    }
  }
  Apart apart;
  for (std::size_t i = 0; i < 3; ++i) {
    const F8 seen_center =
        ((away[0] * entry[i][0] + away[1] * entry[i][1]) + away[2] * entry[i][2]) +
        beside(m[i][3], 0);
    const F8 seen_half = ((half[0] * magnitude(entry[i][0]) + half[1] * magnitude(entry[i][1])) +
                          half[2] * magnitude(entry[i][2])) +
                         margin;
    apart.add({seen_center, seen_half}, {halves_swapped(center[i]), halves_swapped(half[i])});
    if (centers != nullptr) {
      centers->x[i] = F4(_mm256_castps256_ps128(seen_center.v));
      centers->y[i] = F4(_mm256_extractf128_ps(center[i].v, 1));
    }
  }
  return ~apart.bits();
}

void test_nodes(NodeTask* tasks, std::size_t count) {
  // In two steps, each for several tasks, so that no step waits for the results of the other.
  constexpr std::size_t kAtOnce = 8;
  std::array<SeenNodes, kAtOnce> seen;
  for (std::size_t begin = 0; begin < count; begin += kAtOnce) {
    const std::size_t here = std::min(count - begin, kAtOnce);
    for (std::size_t i = 0; i < here; ++i) {
      see(tasks[begin + i], seen[i]);
    }
    for (std::size_t i = 0; i < here; ++i) {
      NodeTask& task = tasks[begin + i];
      if (task.order == 0) {
        task.pairs &= test_pair(task, seen[i], nullptr);
      } else {
        Centers centers;
        task.pairs &= test_pair(task, seen[i], &centers);
        task.below = below_nearest(centers, task.node_ids());
      }
    }
  }
}

}  // namespace

const Kernels& kernels() {
  static constexpr Kernels kTable{
      "avx2",        test_nodes,      test_larger,     append,      test_slabs,    test_boxes,
      meet_box,      judge,           judge_in_double, bound_nodes, near_boxes,    near_pairs,
      bound_boxes,   bound_triangles, ray_nodes,       ray_blocks,  passing_poses, apart_at_corner,
      apart_at_edge, relative_poses,  line_descents,   line_node,   line_block};
  return kTable;
}

}  // namespace soms::detail::avx2

SOMS_TARGET_END
#endif
