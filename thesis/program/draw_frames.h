/// \file
/// The viewer, started for the experiments that draw.
#pragma once

#include "thesis/trips/drawn_frames.h"

#include <string>

namespace soms::command {

/// Has soms-view draw the frames off screen. Where it is not installed, or cannot draw here, the
/// answer says why. \errors ErrorKind::cannot_write for its files.
[[nodiscard]] reproduce::DrawnFrames draw_frames(const reproduce::DrawRequest& request);

/// The answer of `soms-view time-frames --json` from what it printed.
/// `trouble` says so where it is none.
[[nodiscard]] reproduce::DrawnFrames parse_drawn_frames(const std::string& text);

}  // namespace soms::command
