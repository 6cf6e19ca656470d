#include "reproduce/statistics.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>

namespace soms::reproduce {

namespace {

/// Enough that the ends of a 95 % interval hardly move with the seed.
constexpr int kResamples = 1999;

constexpr std::uint64_t kSeed = 20100948;

double median_in_place(std::vector<double>& samples) {
  const auto middle = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  std::nth_element(samples.begin(), middle, samples.end());
  if (samples.size() % 2 != 0) {
    return *middle;
  }
  return std::midpoint(*std::max_element(samples.begin(), middle), *middle);
}

}  // namespace

double median(std::vector<double> samples) {
  return median_in_place(samples);
}

Estimate estimate(std::span<const double> samples) {
  std::vector<double> drawn(samples.begin(), samples.end());
  Estimate result{median(drawn), {}, static_cast<int>(samples.size())};
  // std::mt19937_64 gives the same numbers everywhere; the distributions of the library do not.
  std::mt19937_64 random(kSeed);
  std::vector<double> medians;
  medians.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    std::generate(drawn.begin(), drawn.end(), [&] { return samples[random() % samples.size()]; });
    medians.push_back(median_in_place(drawn));
  }
  std::sort(medians.begin(), medians.end());
  constexpr std::size_t kOut = (kResamples + 1) / 40;  // 2.5 % at either end
  result.interval = {medians[kOut - 1], medians[kResamples - kOut]};
  return result;
}

Estimate paired_ratio(std::span<const double> one, std::span<const double> other) {
  if (one.size() != other.size()) {
    throw std::logic_error("paired_ratio: halves of pairs are missing");
  }
  std::vector<double> ratios;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (other[i] > 0) {
      ratios.push_back(one[i] / other[i]);
    }
  }
  Estimate ratio = estimate(ratios);
  ratio.interval.low *= 1 - kBetweenProcesses;
  ratio.interval.high *= 1 + kBetweenProcesses;
  return ratio;
}

}  // namespace soms::reproduce
