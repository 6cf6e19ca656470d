/// \file
/// A second opinion on the gaps of a simulation, without its trees or a broad phase.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/random.h"
#include "soms/scene/scene.h"

#include "apps/world/world.h"

#include <cstdint>
#include <vector>

namespace soms::command {

/// What brute force said to the gaps of a simulation.
struct VerifiedGaps {
  std::uint64_t near = 0;   ///< movers in a frame that are near something: all their gaps
  std::uint64_t free = 0;   ///< movers in a frame that are near nothing
  std::uint64_t wrong = 0;  ///< movers for which brute force found other gaps

  VerifiedGaps& operator+=(const VerifiedGaps& other) {
    near += other.near;
    free += other.free;
    wrong += other.wrong;
    return *this;
  }
};

/// Checks the gaps of a few movers of every frame against all there is: a linear scan over all
/// triangles for those whose boxes are within the clearance, then the distance of these alone.
class GapVerifier {
 public:
  GapVerifier(const World& world, double clearance, std::uint64_t seed);

  /// What it says to one frame. \errors ErrorKind::cancelled.
  [[nodiscard]] VerifiedGaps verify(const StepReport& report, const std::vector<Pose>& poses,
                                    const Limits& limits);

 private:
  [[nodiscard]] std::vector<MoverId> choose(const StepReport& report, std::size_t movers);
  [[nodiscard]] bool right(MoverId mover, const StepReport& report, const std::vector<Pose>& poses,
                           const Limits& limits) const;
  [[nodiscard]] Body body(MoverId mover, const std::vector<Pose>& poses) const;

  const World& world_;
  double clearance_;
  Rng rng_;
};

}  // namespace soms::command
