/// \file
/// What `soms render` says of the gaps of a recording's frame.
#pragma once

#include "apps/output/json.h"
#include "apps/view/scene/view_scene.h"

#include <optional>
#include <string>

namespace soms::view {

/// ", 3 gaps of at most 0.5 m, the least 0.1234 m"; without a clearance ", gap 0.1234" where
/// `drawn` is the one gap of the picture, else nothing.
[[nodiscard]] std::string words_of_gaps(const ViewScene& scene, const std::optional<Gap>& drawn);

/// Adds the clearance, the number of gaps and the least one; nothing without a clearance.
void add_gaps(command::Json& answer, const ViewScene& scene);

}  // namespace soms::view
