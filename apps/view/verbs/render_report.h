/// \file
/// What `render` says of a picture that it has drawn.
#pragma once

#include "apps/cli/console.h"
#include "apps/output/json.h"
#include "apps/view/drawing/renderer.h"
#include "apps/view/sight/aim.h"
#include "apps/view/verbs/render_moment.h"

namespace soms::view {

/// True if it is clear whose gap is meant: that of one mover, or of two models.
[[nodiscard]] bool draws_gap(const RenderOptions& options, const ViewScene& scene);

/// Whose tree --level draws.
[[nodiscard]] BodyRef level_body(const RenderOptions& options);

/// Adds where on the Earth the scene lies, and what reading its files noted.
void add_facts_of_files(command::Json& answer, const ViewScene& scene);

/// A line for people, or an object with --json. `drawn` is what the picture holds.
void report(const RenderOptions& options, Moment& moment, const AimedCamera& aimed,
            const DrawStatistics& drawn, command::Console& console);

}  // namespace soms::view
