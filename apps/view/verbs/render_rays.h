/// \file
/// The pictures of `render` that are made of rays: --depth and --visible-from.
#pragma once

#include "apps/cli/console.h"
#include "apps/view/verbs/render.h"

namespace soms::view {

/// Meters of the scene's unit; 0 where nobody said it.
[[nodiscard]] double meters_of(const RenderOptions& options, const ViewScene& scene);

/// True if the options ask for such a picture.
[[nodiscard]] bool is_ray_picture(const RenderOptions& options);

/// \errors ErrorKind::usage for both at once, for a map of anything but --visible-from, and for
///         options that would change nothing.
void check_ray_picture(const command::Parser& parser, const RenderOptions& options);

/// Draws and writes it, and says what it shows.
/// \errors As `run_render`.
void write_ray_picture(const RenderOptions& options, ViewScene& scene, command::OutputFile& file,
                       command::Console& console);

}  // namespace soms::view
