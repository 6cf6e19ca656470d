/// \file
/// From a simulation to the head of its recording, and back.
#pragma once

#include "soms/scene/recording.h"

#include "apps/cli/console.h"
#include "apps/world/world.h"

#include <cstdint>
#include <filesystem>

namespace soms::command {

/// The head of a recording of `world` with steps of this clearance, in meters; 0: none. `swept`: of
/// swept steps.
/// \cost Hashes all meshes: about 0.2 s for a million triangles.
[[nodiscard]] RecordingHead recording_head(const World& world, std::uint64_t frames,
                                           double clearance = 0, bool swept = false);

/// Reads or generates again what was recorded. Its routes name the movers' models only: poses come
/// from the recording's frames. A file is sought under its path, then under its path from the
/// folder of `recording`, then under its name in that folder. Of `how` only options of
/// trees and `strict` are used. \errors As reading; ErrorKind::bad_file for a model that is not the
/// one that was recorded.
[[nodiscard]] World load_recorded_world(const RecordingHead& head,
                                        const std::filesystem::path& recording,
                                        const WorldOptions& how, Console& console);

}  // namespace soms::command
