/// \file
/// The verb `view`: a window on a city and what moves in it.
#pragma once

#include "apps/cli/verb.h"
#include "apps/view/window/viewer.h"
#include "apps/world/world_options.h"

#include <cstdint>
#include <optional>
#include <string>

namespace soms::view {

/// Options of the verb `view`.
struct ViewVerbOptions {
  command::WorldOptions world;
  std::string pose;  ///< of --pose; empty: none
  std::string test;  ///< name of the orientation test that begins at once, or empty
  std::optional<std::uint64_t> frame;  ///< of the test, with which it begins
  ViewerOptions viewer;
};

/// Adds the options and returns what opens the window.
[[nodiscard]] command::Action add_view(command::Parser& parser, command::Shared& shared);

/// \errors As `load_world` and `run_viewer`.
[[nodiscard]] int run_view(const ViewVerbOptions& options, command::Console& console);

}  // namespace soms::view
