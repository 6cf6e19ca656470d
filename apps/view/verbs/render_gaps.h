/// \file
/// What `soms render` says of the gaps of a recording's frame.
#pragma once

#include "apps/support/json.h"
#include "apps/view/scene/view_scene.h"

#include <string>

namespace soms::view {

/// ", 3 gaps of at most 0.5 m, the least 0.1234 m"; empty without a clearance.
[[nodiscard]] std::string gaps_in_words(const ViewScene& scene);

/// Adds the clearance, the number of gaps and the least one; nothing without a clearance.
void add_gaps(command::Json& answer, const ViewScene& scene);

}  // namespace soms::view
