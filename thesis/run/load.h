/// \file
/// Whether other programs competed with a run, which makes its times too long.
#pragma once

#include "thesis/run/result.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace soms::reproduce {

/// Threads that ran or waited to run on the whole machine, as means of the last 1, 5 and 15
/// minutes; none where the system does not say.
using LoadAverages = std::optional<std::array<double, 3>>;

/// Figures of a run by which it is judged.
struct Load {
  LoadAverages start = {};             ///< before the run, so of other programs alone
  LoadAverages end = {};               ///< has the run's own thread in it; shown, not judged
  int processors = 1;                  ///< of the machine
  double timed_seconds = 0;            ///< wall time of the experiments that measure times
  double timed_processor_seconds = 0;  ///< processor time of the same
};

/// Above this load average for each processor, in the minute before the run, the machine is busy.
/// The processor of the run may then still be its own, but caches, memory and clock rate are shared
/// with the others. Services of an idle system stay far below it.
inline constexpr double kMostLoad = 0.25;

/// Below this share of processor time in wall time the machine is busy: the experiments compute
/// without a pause, so on an idle machine the share is above 0.99. A loss of 5 % is as large as the
/// differences between rules that times are to show.
inline constexpr double kLeastShare = 0.95;

/// The share is judged from this many seconds on: of a shorter run, one time slice of another
/// program is a large part.
inline constexpr double kLeastSeconds = 1;

/// Why the machine counts as busy, each as part of a sentence; empty if it does not, and for a run
/// that measured no times.
[[nodiscard]] std::vector<std::string> signs_of_load(const Load& load);

/// True if a table or a figure of the result shows times.
[[nodiscard]] bool shows_times(const Result& result);

/// Of now.
[[nodiscard]] LoadAverages load_averages();

/// Processor time so far of this process, with all its threads, and of the children it waited for.
[[nodiscard]] double processor_seconds();

}  // namespace soms::reproduce
