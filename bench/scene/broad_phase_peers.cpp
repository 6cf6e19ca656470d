#include "bench/scene/broad_phase_peers.h"

extern "C" void soms_bench_broad_phase_peers(
    std::vector<soms::bench::BroadPhasePeerMaker>& makers) {
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
