/// \file
/// How the panels look: their font, colors and distances.
#pragma once

#include <string_view>

namespace soms::view {

/// A TrueType font, DejaVu Sans, whose tables name its authors and its license. Decision 0053.
[[nodiscard]] std::string_view panel_font();

/// Colors, sizes and font of the panels, for a display of this many pixels for each point. Once
/// after a context is made, before the first frame.
void set_style(double scale);

}  // namespace soms::view
