/// \file
/// The verbs of soms-view.
#pragma once

#include "apps/cli/verb.h"

#include <span>

namespace soms::view {

/// All verbs, by name.
[[nodiscard]] std::span<const command::Verb> verbs();

}  // namespace soms::view
