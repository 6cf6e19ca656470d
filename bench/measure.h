/// \file
/// What small benchmarks measure by.
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace soms::bench {

/// Processor time of this process so far.
inline double processor_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The one in the middle, the greater of two. \pre There is one.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace soms::bench
