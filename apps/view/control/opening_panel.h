/// \file
/// What is shown before there is a scene.
#pragma once

#include <string>

namespace soms::view {

/// Draws what is done now, and the share of it that is done unless that is negative, in the middle
/// of the window. \pre A context of Dear ImGui with a frame begun.
void draw_opening(const std::string& doing, double share);

}  // namespace soms::view
