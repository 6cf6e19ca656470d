#include "bench/motion/motion_peers.h"

extern "C" void soms_bench_motion_peers(std::vector<soms::bench::MotionPeerMaker>& makers) {
  static_cast<void>(makers);
#if SOMS_BENCH_FCL
  soms::bench::add_fcl(makers);
#endif
}
