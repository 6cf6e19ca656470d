#include "bench/clash/clash_peers.h"

extern "C" void soms_bench_clash_peers(std::vector<soms::bench::ClashPeerMaker>& makers) {
  static_cast<void>(makers);
#if SOMS_BENCH_FCL
  soms::bench::add_fcl_clash(makers);
#endif
#if SOMS_BENCH_OCCT
  soms::bench::add_occt_clash(makers);
#endif
}
