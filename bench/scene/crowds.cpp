#include "bench/scene/crowd.h"

extern "C" void soms_bench_crowds(std::vector<soms::bench::CrowdMaker>& makers) {
  static_cast<void>(makers);
#if SOMS_BENCH_FCL
  soms::bench::add_fcl(makers);
#endif
#if SOMS_BENCH_BULLET
  soms::bench::add_bullet(makers);
#endif
#if SOMS_BENCH_CGAL
  soms::bench::add_cgal(makers);
#endif
}
