/// \file
/// Scenes from simulations, from two models, and from a dropped file.
#pragma once

#include "soms/base/parallel.h"
#include "soms/query/body.h"
#include "soms/scene/replay.h"

#include "apps/view/scene/scene_content.h"
#include "apps/world/world.h"

#include <filesystem>
#include <string>
#include <vector>

namespace soms::view {

/// The city and the movers of a simulation, whose routes are their motions.
[[nodiscard]] SceneContent content_of(command::World world);

/// The bodies of a recording (`command::load_recorded_world`) and its frames. Where the file is cut
/// off or altered, the frames before that place, and a note that says so.
/// \errors ErrorKind::usage where `world` has not the recording's bodies.
[[nodiscard]] SceneContent content_of(command::World world, Replay recording);

/// A recording from its file, with the models that it names.
/// \errors As `Replay` and `command::load_recorded_world`; ErrorKind::usage where `options` ask for
///         movers or routes: a recording has its own.
[[nodiscard]] SceneContent load_recording(const std::filesystem::path& path,
                                          const command::WorldOptions& options,
                                          command::Console& console);

/// Two bodies for the orientation tests: `moving` comes at `still`.
[[nodiscard]] SceneContent two_bodies(Body still, Body moving);

/// A body, and what the reader should know of how it was read.
struct DroppedBody {
  Body body;
  std::vector<std::string> notes;
};

/// A body from a file that was dropped: where the file puts it, turned to z up where the file
/// states another axis, named after the file. The notes are those of the file, of the turn, and of
/// a unit other than a meter, which is not converted. \errors As `read_mesh` and `Shape`.
[[nodiscard]] DroppedBody read_body(const std::filesystem::path& path, const Limits& limits = {});

}  // namespace soms::view
