/// \file
/// Estimates from repeated measurements, with intervals that say how far to trust them.
#pragma once

#include "apps/draw/interval.h"

#include <span>
#include <vector>

namespace soms::reproduce {

/// A median and its 95 % interval.
struct Estimate {
  double value = 0;
  Interval interval = {};
  int rounds = 0;     ///< measurements it rests on
  int processes = 1;  ///< that they come from
};

/// Middle of samples, of an even number the mean of the two in the middle. \pre not empty.
[[nodiscard]] double median(std::vector<double> samples);

/// The median of measurements with its 95 % interval by the percentile bootstrap in two steps:
/// drawn again are processes, then rounds of each. So an interval tells of what differs from
/// process to process, as placement in memory does, where there are several; of other machines and
/// compilers it tells nothing. `samples` are those of the processes one after the other, as many of
/// each. Seeded: the same samples give the same interval.
/// \pre not empty. \errors std::logic_error unless `processes` divides their number.
/// \source Davison and Hinkley, Bootstrap Methods and their Application, 1997, section 3.8
[[nodiscard]] Estimate estimate(std::span<const double> samples, int processes);

/// The same of the ratios of paired rounds, `one[i] / other[i]`: what slows the machine for a while
/// slows both halves of a pair. Pairs whose second half is 0 are left out.
/// \pre as many of one as of the other, and a pair is left.
[[nodiscard]] Estimate paired_ratio(std::span<const double> one, std::span<const double> other,
                                    int processes);

}  // namespace soms::reproduce
