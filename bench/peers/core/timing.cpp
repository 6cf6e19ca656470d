#include "bench/peers/core/timing.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace soms::bench {

namespace {

constexpr double kLeastPass = 0.02;

double run(Match& match, std::span<const Pose> poses, std::span<std::uint8_t> answers,
           std::size_t repeats) {
  const double start = processor_seconds();
  for (std::size_t i = 0; i < repeats; ++i) {
    match.any(poses, answers);
  }
  return (processor_seconds() - start) / static_cast<double>(repeats * poses.size());
}

}  // namespace

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<Timing> race(std::span<const std::unique_ptr<Match>> matches,
                         std::span<const Pose> poses, int passes,
                         std::vector<std::vector<std::uint8_t>>& answers) {
  const std::size_t n = matches.size();
  std::vector<std::size_t> repeats(n);
  std::vector<std::vector<double>> seconds(n);
  answers.assign(n, std::vector<std::uint8_t>(poses.size()));
  for (std::size_t i = 0; i < n; ++i) {
    const double pass = run(*matches[i], poses, answers[i], 1) * static_cast<double>(poses.size());
    repeats[i] = static_cast<std::size_t>(std::ceil(std::clamp(kLeastPass / pass, 1.0, 1e4)));
  }
  std::vector<std::uint8_t> again(poses.size());
  for (int p = 0; p < passes; ++p) {
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(p)) % n;
      seconds[i].push_back(run(*matches[i], poses, again, repeats[i]));
    }
  }
  std::vector<Timing> timings;
  for (auto& s : seconds) {
    std::sort(s.begin(), s.end());
    timings.push_back({s[s.size() / 2], s.front(), s.back()});
  }
  return timings;
}

}  // namespace soms::bench
