/// \file
/// What soms set out to reach, beside every figure.
#pragma once

#include "bench/peers/libraries/library.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms::bench {

/// Which peers a goal is about.
enum class Against {
  all,               ///< every peer of the cell
  keeps_tree,        ///< those whose tree lasts from frame to frame
  from_scratch,      ///< those that start over in each frame
  by_distance,       ///< soms itself, which works out the distance: not halved without AVX-512
  by_overlap,        ///< soms itself, which says whether surfaces meet: not halved either
  by_overlap_batch,  ///< the same in batches
  watertight,        ///< those whose rays slip through no edge
  clock,             ///< none: millions of answers a second
};

/// So many times as fast as the best peer; 0 where only the ratio is shown.
struct Goal {
  std::string library;  ///< `soms` or `soms-batch`
  double times = 0;
  Against against = Against::all;
};

/// So many times as fast as the best peer in the median of all cells of the scenes whose names
/// begin so.
struct MedianGoal {
  Job job = Job::any;
  std::string scenes;
  std::string library;
  double times = 0;
};

/// Bytes a triangle that a shape may hold, all in.
inline constexpr double kMostBytes = 120;

/// The goals of a cell, on a machine with AVX-512; half of each with less.
[[nodiscard]] std::vector<Goal> goals_of(Job job, const std::string& scene, const std::string& set,
                                         std::uint64_t triangles, const std::string& isa);

/// The goals of medians, halved likewise.
[[nodiscard]] std::vector<MedianGoal> median_goals(const std::string& isa);

}  // namespace soms::bench
