/// \file
/// What soms set out to reach, beside every figure.
#pragma once

#include "bench/peers/contestants/contestant.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms::bench {

/// Which rivals a goal is about.
enum class Against {
  all,           ///< every rival of the cell
  keeps_tree,    ///< those whose tree lasts from frame to frame
  from_scratch,  ///< those that begin anew in each frame
};

/// So many times as fast as the best rival.
struct Goal {
  std::string contestant;  ///< `soms` or `soms-batch`
  double times = 0;
  Against against = Against::all;
};

/// Bytes a triangle that a shape may hold, all in.
inline constexpr double kMostBytes = 120;

/// The goals of a cell, on a machine with AVX-512; half of each with less.
[[nodiscard]] std::vector<Goal> goals_of(Job job, const std::string& scene, const std::string& set,
                                         std::uint64_t triangles, const std::string& isa);

}  // namespace soms::bench
