/// \file
/// A course of a body past another by all readings of E-Node, and what is right and wrong on it.
#pragma once

#include "soms/base/limits.h"

#include "thesis/races/e_node_readings.h"
#include "thesis/races/earlier_nodes.h"
#include "thesis/races/rides.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace soms::reproduce {

/// Levels that are shown: those of figure 4.30, 5.5, of tables 5.8, 5.9 and 5.3, and two between.
inline constexpr std::array kShownLevels{1, 3, 5, 6, 7, 9, 11, 12, 13, 15};

/// First frames of a trip in which something overlaps.
struct FirstFrames {
  std::string model;
  std::string still;
  std::string test;
  std::size_t frames = 0;
  std::size_t root = kNoFrame;
  std::size_t earlier = kNoFrame;  ///< by boxes of kEarlierLevel
  std::size_t leaf = kNoFrame;
  std::size_t contact = kNoFrame;
};

/// A course by all readings.
struct CourseWork {
  std::string model;
  std::string subject;
  std::size_t frames = 0;
  std::size_t contact_frames = 0;
  std::vector<EnodeTripWork> work = std::vector<EnodeTripWork>(e_node_readings().size());
  std::vector<EarlierLevel> levels = {};  ///< level 1 first; of kShownLevels
};

/// Adds counts; not `first_frame`, which is one trip's.
void add(EarlierLevel& sum, const EarlierLevel& one);

/// The tree at this level; where all nodes end above it, at the last. \pre There is a level.
[[nodiscard]] const EarlierLevel& at_level(std::span<const EarlierLevel> levels, int level);

/// The work that a reading does for its answer. `level` is that of kEarlierLevel.
[[nodiscard]] EnodeWork work_of(const EnodeReading& reading, const EnodeTripWork& work,
                                const EarlierLevel& level);

/// Runs a trip by all readings and adds it to its course, its first frames to `first`.
/// \errors std::logic_error where answers disagree; ErrorKind::cancelled.
void run_trip(const Trip& trip, CourseWork& course, std::vector<FirstFrames>& first,
              const Limits& limits);

}  // namespace soms::reproduce
