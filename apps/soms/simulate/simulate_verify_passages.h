/// \file
/// A second opinion on what a simulation says of the ways between its frames.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/random.h"
#include "soms/scene/step_report.h"

#include "apps/world/world.h"

#include <cstdint>
#include <vector>

namespace soms::command {

/// What brute force said to the passages of a simulation.
struct VerifiedPassages {
  std::uint64_t passages = 0;
  std::uint64_t free = 0;   ///< pairs of bodies of a frame that are in none of its lists
  std::uint64_t wrong = 0;  ///< of both, where brute force found something else

  VerifiedPassages& operator+=(const VerifiedPassages& other) {
    passages += other.passages;
    free += other.free;
    wrong += other.wrong;
    return *this;
  }
};

/// Checks a few passages of every frame, and a few pairs that have none, as `motion --verify` does.
class PassageVerifier {
 public:
  PassageVerifier(const World& world, std::uint64_t seed) : world_(world), rng_(seed) {}

  /// What it says to the way from the poses before to those of the report.
  /// \errors ErrorKind::cancelled.
  [[nodiscard]] VerifiedPassages verify(const StepReport& report, const std::vector<Pose>& before,
                                        const std::vector<Pose>& poses, const Limits& limits);

 private:
  const World& world_;
  Rng rng_;
};

}  // namespace soms::command
