/// \file
/// Trees, traversal and boxes that go together, under one name.
#pragma once

#include "apps/view/control/view_state.h"

#include <optional>

namespace soms::view {

enum class Preset {
  product,  ///< what the window starts with: Traversal::fast, trees by SOMS, no boxes
  thesis,   ///< `thesis_options` of SOMS, E-Node with descent both, and the boxes of fig. 4.35
};

/// Chooses all that a preset stands for.
void choose(ViewState& state, Preset preset);

/// Shows the boxes of the traversal, by E-Node in place of Traversal::fast, which has none to show.
void show_traversed(ViewState& state);

/// The preset whose trees and traversal are chosen, whatever boxes are shown; nothing if none is.
[[nodiscard]] std::optional<Preset> preset_of(const ViewState& state);

}  // namespace soms::view
