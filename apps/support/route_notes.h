/// \file
/// What a run makes of its routes, and what a reader of its answer must know of that.
#pragma once

#include "apps/support/world.h"

#include <cstdint>
#include <string>

namespace soms::command {

/// Says `note` on standard error and in the answer; with `strict` it is an error instead.
/// \errors ErrorKind::bad_file.
void note_route(World& world, const std::string& note, const std::string& remedy, bool strict,
                const Console& console);

/// Rows of the longest route of poses; 0 where there is none.
[[nodiscard]] std::uint64_t longest_poses(const World& world);

/// Frames of a run whose user names no number: `usual`, or one for each row of the longest route of
/// poses. Beside such routes, those of points need `usual` frames or more.
[[nodiscard]] std::uint64_t frames_of_routes(const World& world, std::uint64_t usual);

/// Notes that the run ends before the last row of a route of poses. \errors As `note_route`.
void note_unused_rows(World& world, std::uint64_t frames, bool strict, const Console& console);

/// Notes movers that follow a line in steps longer than themselves: between two frames they can
/// pass what is thin. \errors As `note_route`.
void note_long_steps(World& world, bool strict, const Console& console);

}  // namespace soms::command
