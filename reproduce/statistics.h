/// \file
/// Estimates from repeated measurements, with intervals that say how far to trust them.
#pragma once

#include <span>
#include <vector>

namespace soms::reproduce {

/// A closed range of numbers.
struct Interval {
  double low = 0;
  double high = 0;
};

/// A median and its 95 % interval.
struct Estimate {
  double value = 0;
  Interval interval = {};
  int rounds = 0;  ///< measurements it rests on
};

/// Middle of samples, of an even number the mean of the two in the middle. \pre not empty.
[[nodiscard]] double median(std::vector<double> samples);

/// The median of independent measurements with its 95 % interval by the percentile bootstrap.
/// Seeded: the same samples give the same interval. The interval tells of the rounds of this run,
/// not of other machines, compilers or placements in memory. \pre not empty.
/// \source Efron and Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13.
[[nodiscard]] Estimate estimate(std::span<const double> samples);

/// What an interval of a ratio of times is widened by at either end, as a share of it, for what
/// rounds of one process cannot show: placement in memory differs from process to process.
inline constexpr double kBetweenProcesses = 0.02;

/// The median ratio of paired rounds, `one[i] / other[i]`, with its 95 % interval, widened by
/// kBetweenProcesses: what slows the machine for a while slows both halves of a pair. Pairs whose
/// second half is 0 are left out.
/// \pre as many of one as of the other, and a pair is left.
[[nodiscard]] Estimate paired_ratio(std::span<const double> one, std::span<const double> other);

}  // namespace soms::reproduce
