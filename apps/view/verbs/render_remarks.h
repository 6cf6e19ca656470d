/// \file
/// What is said of a picture beside its answer.
#pragma once

#include "apps/cli/console.h"
#include "apps/view/drawing/camera.h"
#include "apps/view/scene/view_scene.h"
#include "apps/view/verbs/render.h"

namespace soms::view {

/// Says which files, places and movers the picture is made without.
void remark_what_is_left_out(const RenderOptions& options, const ViewScene& scene,
                             const command::Console& console);

/// Says that something is cut away, if it is.
void remark_cut(const RenderOptions& options, const Camera& camera,
                const command::Console& console);

}  // namespace soms::view
