/// \file
/// The queries that the broad phases of several libraries share.
#pragma once

#include "soms/base/box.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::bench {

/// Pairs as `a << 32 | b`, in any order.
using PairList = std::vector<std::uint64_t>;

/// Many boxes that move, in the hands of one library.
class BroadPhasePeer {
 public:
  virtual ~BroadPhasePeer() = default;

  /// All boxes are now these; fills `pairs` with those that share a point.
  virtual void step(std::span<const Box> boxes, PairList& pairs) = 0;
};

/// A library's way to keep moving boxes.
struct BroadPhasePeerMaker {
  std::string name;
  bool keeps = false;  ///< something from step to step
  std::unique_ptr<BroadPhasePeer> (*make)(std::span<const Box>) = nullptr;
};

// Each adds what its library offers; they lie in a shared library of their own.
void add_bullet(std::vector<BroadPhasePeerMaker>& makers);
void add_cgal(std::vector<BroadPhasePeerMaker>& makers);
void add_fcl(std::vector<BroadPhasePeerMaker>& makers);

/// A pair in the list's form.
[[nodiscard]] inline std::uint64_t packed(std::uint64_t a, std::uint64_t b) {
  return a < b ? a << 32 | b : b << 32 | a;
}

}  // namespace soms::bench

/// All peers that were found when this was built.
extern "C" void soms_bench_broad_phase_peers(std::vector<soms::bench::BroadPhasePeerMaker>& makers);
