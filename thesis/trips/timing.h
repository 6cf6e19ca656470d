/// \file
/// Repeated timing, as medians with their spread.
#pragma once

#include "soms/base/limits.h"

#include <functional>
#include <span>
#include <vector>

namespace soms::reproduce {

/// Milliseconds of processor time that this thread has used since it began: what other programs do
/// meanwhile does not count, though they may slow it through shared caches.
[[nodiscard]] double processor_milliseconds();

/// Milliseconds of repeated runs.
struct Timing {
  double median = 0;
  double lower_quartile = 0;
  double upper_quartile = 0;
  double mean = 0;
  double min = 0;
  double max = 0;
  double deviation = 0;  ///< standard deviation
  int repetitions = 0;
  std::vector<double> rounds = {};  ///< the samples, in the order they were taken
  int processes = 1;                ///< that took them, one after the other, as many each
};

/// Order statistics of samples in milliseconds. \pre not empty.
[[nodiscard]] Timing summarize(std::vector<double> milliseconds, int processes = 1);

/// Runs `work` `warm_up` times unmeasured, then `repetitions` times by the thread's processor time.
/// \errors ErrorKind::cancelled between runs; those of `work`.
[[nodiscard]] Timing time_repeatedly(int repetitions, const Limits& limits,
                                     const std::function<void()>& work, int warm_up = 10);

/// Times several works in turn, round by round, every other round in the reverse order, so that a
/// change of the machine's speed meets all alike: round i of one and round i of another are a pair.
/// From then on the process keeps memory that it frees (with glibc, blocks up to 32 MB), so that
/// works find it again after the warm-up.
/// \shape one Timing a work.
[[nodiscard]] std::vector<Timing> time_in_turn(int repetitions, const Limits& limits,
                                               std::span<const std::function<void()>> works,
                                               int warm_up = 10);

}  // namespace soms::reproduce
