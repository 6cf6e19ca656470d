/// \file
/// What a run makes of its routes, and what a reader of its answer must know of that.
#pragma once

#include "apps/world/world.h"

#include <cstdint>
#include <string>

namespace soms::command {

/// Rows of the longest route of poses; 0 where there is none.
[[nodiscard]] std::uint64_t longest_poses(const World& world);

/// Frames of a run whose user names no number: `usual`, or one for each row of the longest route of
/// poses. Beside such routes, those of points need `usual` frames or more.
[[nodiscard]] std::uint64_t frames_of_routes(const World& world, std::uint64_t usual);

/// Notes routes of poses of different lengths. Their rows belong together, row by row: where one is
/// shorter, it starts over while the others go on.
/// \errors ErrorKind::bad_file instead of the note, with `strict`.
void note_uneven_routes(World& world, bool strict, const Console& console);

/// Notes that the run ends before the last row of a route of poses.
/// \errors As `note_uneven_routes`.
void note_unused_rows(World& world, std::uint64_t frames, bool strict, const Console& console);

/// Notes movers that follow a line in steps longer than themselves: between two frames they can
/// pass what is thin. \errors As `note_uneven_routes`.
void note_long_steps(World& world, bool strict, const Console& console);

}  // namespace soms::command
