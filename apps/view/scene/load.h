/// \file
/// Scenes from files, from the command line's options, and by generation.
#pragma once

#include "soms/base/parallel.h"
#include "soms/geometry/mesh.h"

#include "apps/view/scene/scene_content.h"

#include <filesystem>
#include <memory>

namespace soms::view {

/// Two bodies for the thesis' tests: `moving` comes at `still`, both where their files put them.
[[nodiscard]] SceneContent two_bodies(std::shared_ptr<const Mesh> still,
                                      std::shared_ptr<const Mesh> moving,
                                      const Parallel& parallel = {});

/// A mover from a file that was dropped, at its own place, turned to z up where the file states
/// another axis. \errors As `read_mesh`.
[[nodiscard]] MovingBody read_mover(const std::filesystem::path& path,
                                    const Parallel& parallel = {});

}  // namespace soms::view
