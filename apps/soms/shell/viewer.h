/// \file
/// The program soms-view, which shows and draws; the command starts it and never links OpenGL.
#pragma once

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/world/world_options.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

/// The words that make soms-view load the world that `simulate` would.
[[nodiscard]] std::vector<std::string> words_of(const WorldOptions& world, const Shared& shared);

/// Opens a window on the world; returns soms-view's exit status. `more` are further words.
[[nodiscard]] int show_world(const WorldOptions& world, const std::vector<std::string>& more,
                             const Console& console);

/// Draws a frame of a recording into a PNG file; returns soms-view's exit status.
[[nodiscard]] int draw_frame(const std::filesystem::path& recording, std::uint64_t frame,
                             const std::string& picture, const Console& console);

}  // namespace soms::command
