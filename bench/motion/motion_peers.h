/// \file
/// Motions as other libraries answer them.
#pragma once

#include "soms/base/pose.h"

#include "bench/peers/libraries/library.h"

#include <memory>
#include <string>
#include <vector>

namespace soms::bench {

/// What a library says of a motion.
struct PeerContact {
  bool contact = false;
  double at = 1;  ///< part of the way
};

/// A mover and a fixed body in the hands of one library.
class MotionPeer {
 public:
  virtual ~MotionPeer() = default;

  /// The origin of the mover goes straight from pose to pose while the mover turns about it.
  [[nodiscard]] virtual PeerContact find(const Pose& start, const Pose& end,
                                         const Pose& fixed) const = 0;
};

/// A library's way to answer motions.
struct MotionPeerMaker {
  std::string name;
  std::unique_ptr<MotionPeer> (*make)(const FloatMesh& mover, const FloatMesh& fixed) = nullptr;
};

// It lies in a shared library of its own.
void add_fcl(std::vector<MotionPeerMaker>& makers);

}  // namespace soms::bench

/// All peers that were found when this was built.
extern "C" void soms_bench_motion_peers(std::vector<soms::bench::MotionPeerMaker>& makers);
