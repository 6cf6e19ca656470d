/// \file
/// Fair timing of several contestants on one set of poses.
#pragma once

#include "bench/peers/contestants/contestant.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace soms::bench {

/// Processor time of this process in seconds: on a shared machine it leaves out what others get.
[[nodiscard]] double processor_seconds();

/// Seconds a pose over the timed passes.
struct Timing {
  double median = 0;
  double least = 0;
  double most = 0;
};

/// Times `passes` passes of each match, in turn and in a turning order, so that noise and warmth
/// meet all alike. A pass repeats the whole set until it lasts 20 ms at least. `answers` gets the
/// answers of an untimed pass before.
[[nodiscard]] std::vector<Timing> race(std::span<const std::unique_ptr<Match>> matches,
                                       std::span<const Pose> poses, int passes,
                                       std::vector<std::vector<std::uint8_t>>& answers);

}  // namespace soms::bench
