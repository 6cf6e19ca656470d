#include "thesis/trips/timing.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <utility>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace soms::reproduce {

namespace {

/// Value at a share of ascending samples, between neighbors in proportion.
double quantile(const std::vector<double>& ascending, double share) {
  const double at = share * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return std::lerp(ascending[below], ascending[above], at - static_cast<double>(below));
}

double milliseconds_of(const std::function<void()>& work) {
  const double start = processor_milliseconds();
  work();
  return processor_milliseconds() - start;
}

/// Left to itself, glibc hands freed memory back to the system or keeps it, as what the process did
/// before has it. Fresh pages can cost as much as half of a build, and one of two works may pay for
/// them in one run and the other in the next.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kGreatestThreshold = 32 << 20;  // that glibc accepts; blocks above it are mapped
  constexpr int kNever = -1;
  mallopt(M_MMAP_THRESHOLD, kGreatestThreshold);
  mallopt(M_TRIM_THRESHOLD, kNever);
#endif
}

}  // namespace

double processor_milliseconds() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

Timing summarize(std::vector<double> milliseconds, int processes) {
  std::vector<double> rounds = milliseconds;
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto count = static_cast<double>(milliseconds.size());
  const double mean = std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0) / count;
  double squares = 0;
  for (const double sample : milliseconds) {
    squares += (sample - mean) * (sample - mean);
  }
  return {.median = quantile(milliseconds, 0.5),
          .lower_quartile = quantile(milliseconds, 0.25),
          .upper_quartile = quantile(milliseconds, 0.75),
          .mean = mean,
          .min = milliseconds.front(),
          .max = milliseconds.back(),
          .deviation = milliseconds.size() < 2 ? 0 : std::sqrt(squares / (count - 1)),
          .repetitions = static_cast<int>(milliseconds.size()),
          .rounds = std::move(rounds),
          .processes = processes};
}

Timing time_repeatedly(int repetitions, const Limits& limits, const std::function<void()>& work,
                       int warm_up) {
  return time_in_turn(repetitions, limits, std::span(&work, 1), warm_up).front();
}

std::vector<Timing> time_in_turn(int repetitions, const Limits& limits,
                                 std::span<const std::function<void()>> works, int warm_up) {
  keep_freed_memory();
  std::vector<std::vector<double>> samples(works.size());
  for (int round = -warm_up; round < repetitions; ++round) {
    for (std::size_t k = 0; k < works.size(); ++k) {
      const std::size_t i = round % 2 == 0 ? k : works.size() - 1 - k;
      check_stop(limits);
      const double sample = milliseconds_of(works[i]);
      if (round >= 0) {
        samples[i].push_back(sample);
      }
    }
  }
  std::vector<Timing> timings;
  timings.reserve(samples.size());
  for (std::vector<double>& of_one : samples) {
    timings.push_back(summarize(std::move(of_one)));
  }
  return timings;
}

}  // namespace soms::reproduce
