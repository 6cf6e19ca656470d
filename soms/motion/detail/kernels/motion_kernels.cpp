#include "soms/motion/detail/kernels/motion_kernels.h"

#include "soms/query/instruction_set.h"

#include <cmath>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace soms::detail {

namespace {

constexpr std::size_t kDoubles = 2;
#include "soms/query/detail/kernels/lanes_double.h"

//
inline WideDouble root(const WideDouble& a) {
#if defined(__SSE2__)
  return WideDouble(_mm_sqrt_pd(a.v));
#else
  return WideDouble(WideDouble::Lanes{std::sqrt(a.v[0]), std::sqrt(a.v[1])});
#endif
}

#include "soms/motion/detail/kernels/wide_vectors.h"
//
#include "soms/motion/detail/kernels/node_windows.h"
#include "soms/motion/detail/kernels/triangle_windows.h"

constexpr MotionKernels kPlain{meet_nodes, sweep, place, meet_box, meet_triangle};

}  // namespace

const MotionKernels& motion_kernels(std::string_view instruction_set) {
#if defined(__x86_64__)
  if (instruction_set == "avx2" || instruction_set == "avx512") {
    return motion_kernels_of_avx2();
  }
#else
  static_cast<void>(instruction_set);
#endif
  return kPlain;
}

const MotionKernels& motion_kernels() {
  static const MotionKernels& chosen = motion_kernels(instruction_set());
  return chosen;
}

}  // namespace soms::detail
