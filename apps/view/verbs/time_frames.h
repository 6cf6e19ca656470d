/// \file
/// The verb `time-frames`: what each frame of a moving model takes, drawing and without.
#pragma once

#include "soms/thesis/traversal_options.h"

#include "apps/cli/verb.h"
#include "apps/view/drawing/camera.h"
#include "apps/world/world_options.h"

#include <string>

namespace soms::view {

/// Options of the verb `time-frames`.
struct TimeFramesOptions {
  command::WorldOptions world = {};
  TraversalOptions traversal{.traversal = Traversal::e_node, .descent = Descent::larger};
  std::string pose = {};  ///< CSV file of poses, a frame each
  int mover_levels = -1;  ///< of the mover's tree; below 0: those of the city's
  Size size{640, 480};    ///< a usual size when the thesis was written
  int samples = 1;
  int passes = 3;  ///< over all frames, drawing and not; each time is the median of them
};

/// Adds the options and returns what times the frames.
[[nodiscard]] command::Action add_time_frames(command::Parser& parser, command::Shared& shared);

/// \errors As `HeadlessContext` and `command::load_world`; ErrorKind::usage unless there are one
///         mover and a file of poses.
[[nodiscard]] int run_time_frames(const TimeFramesOptions& options, command::Console& console);

}  // namespace soms::view
