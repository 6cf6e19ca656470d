#include "thesis/trips/statistics.h"

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

/// Samples by process, none without any.
using Clusters = std::vector<std::vector<double>>;

/// The same number of samples for each process, one process after the other.
std::size_t share_of(std::size_t samples, int processes) {
  const auto parts = static_cast<std::size_t>(processes);
  if (parts == 0 || samples % parts != 0) {
    throw std::logic_error("estimate: processes differ in how much they measured");
  }
  return samples / parts;
}

/// Draws as many processes as there are, and as many samples of each as it has.
void draw(const Clusters& clusters, std::mt19937_64& random, std::vector<double>& drawn) {
  drawn.clear();
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const std::vector<double>& of_one =
        clusters.size() == 1 ? clusters.front() : clusters[random() % clusters.size()];
    for (std::size_t k = 0; k < of_one.size(); ++k) {
      drawn.push_back(of_one[random() % of_one.size()]);
    }
  }
}

Estimate estimate_of(const Clusters& clusters) {
  std::vector<double> drawn;
  for (const std::vector<double>& of_one : clusters) {
    drawn.insert(drawn.end(), of_one.begin(), of_one.end());
  }
  Estimate result{
      median(drawn), {}, static_cast<int>(drawn.size()), static_cast<int>(clusters.size())};
  // std::mt19937_64 gives the same numbers everywhere; the distributions of the library do not.
  std::mt19937_64 random(kSeed);
  std::vector<double> medians;
  medians.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    draw(clusters, random, drawn);
    medians.push_back(median_in_place(drawn));
  }
  std::sort(medians.begin(), medians.end());
  constexpr std::size_t kOut = (kResamples + 1) / 40;  // 2.5 % at either end
  result.interval = {medians[kOut - 1], medians[kResamples - kOut]};
  return result;
}

}  // namespace

double median(std::vector<double> samples) {
  return median_in_place(samples);
}

Estimate estimate(std::span<const double> samples, int processes) {
  const std::size_t share = share_of(samples.size(), processes);
  Clusters clusters;
  for (; !samples.empty(); samples = samples.subspan(share)) {
    clusters.emplace_back(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(share));
  }
  return estimate_of(clusters);
}

Estimate paired_ratio(std::span<const double> one, std::span<const double> other, int processes) {
  if (one.size() != other.size()) {
    throw std::logic_error("paired_ratio: halves of pairs are missing");
  }
  const std::size_t share = share_of(one.size(), processes);
  Clusters clusters(static_cast<std::size_t>(processes));
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (other[i] > 0) {
      clusters[i / share].push_back(one[i] / other[i]);
    }
  }
  std::erase_if(clusters, [](const std::vector<double>& of_one) { return of_one.empty(); });
  return estimate_of(clusters);
}

}  // namespace soms::reproduce
