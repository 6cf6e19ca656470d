/// \file
/// Fair timing of several libraries on one set of questions.
#pragma once

#include "bench/peers/core/machine.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace soms::bench {

/// One library of a race: answers questions 0 to `answers.size()` - 1 of a set.
struct Lane {
  std::string library;
  std::function<void(std::span<double> answers)> run;
};

struct RaceOptions {
  int rounds = 7;
  double budget = 0.1;       ///< seconds that one pass of the fastest peer may take
  double least_pass = 0.02;  ///< a pass is repeated until it lasts so many seconds
  std::function<double()> clock = processor_seconds;  ///< seconds since any moment
};

/// Seconds an answer over the timed rounds.
struct Timing {
  double median = 0;
  double least = 0;
  double most = 0;
};

/// What a lane did. A slow one answered fewer questions than the others (`answers.size()`).
struct Outcome {
  Timing timing;
  std::vector<double> answers;  ///< of an untimed pass before
};

/// True for soms itself, by the name of a library.
[[nodiscard]] bool is_ours(const std::string& library);

/// Times `lanes` in turn and in a turning order, so that noise and warmth meet all alike. The set
/// is cut to the questions that the fastest peer answers within the budget, the same for all; a
/// lane that would take more than three times the budget answers a part of them, in fewer rounds.
[[nodiscard]] std::vector<Outcome> race(std::span<const Lane> lanes, std::size_t questions,
                                        const RaceOptions& options);

}  // namespace soms::bench
