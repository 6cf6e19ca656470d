// AVX2: four triangles at a time.
#include "soms/motion/detail/kernels/motion_kernels.h"

#if defined(__x86_64__)
#include "soms/query/detail/kernels/target.h"

#include <immintrin.h>

#include <cmath>
#include <cstring>
#include <limits>

SOMS_TARGET_BEGIN("avx2,popcnt,bmi")

namespace soms::detail {

namespace {

constexpr std::size_t kDoubles = 4;
#include "soms/query/detail/kernels/lanes_double.h"

//
inline WideDouble root(const WideDouble& a) {
  return WideDouble(_mm256_sqrt_pd(a.v));
}

#include "soms/motion/detail/kernels/wide_vectors.h"
//
#include "soms/motion/detail/kernels/node_windows.h"
#include "soms/motion/detail/kernels/triangle_windows.h"

}  // namespace

const MotionKernels& motion_kernels_of_avx2() {
  static constexpr MotionKernels kTable{meet_nodes, sweep, place, meet_box, meet_triangle};
  return kTable;
}

}  // namespace soms::detail

SOMS_TARGET_END
#endif
