/// \file
/// Letters as strokes of a round pen, for numbers, keys and titles: sharp at any size, and the same
/// everywhere.
#pragma once

#include <string_view>
#include <vector>

namespace soms::look {

/// A place in a line of text: x to the right from its start, y up from its base line.
struct TextPoint {
  double x = 0;
  double y = 0;
};

/// A straight stroke; one without length is a dot.
struct TextStroke {
  TextPoint from;
  TextPoint to;
};

/// The strokes of `text`, whose digits are `height` high. There are the letters and digits of ASCII
/// and most of its signs; other bytes become boxes.
[[nodiscard]] std::vector<TextStroke> strokes_of(std::string_view text, double height);

/// From the start of the first letter to the end of the last.
[[nodiscard]] double width_of(std::string_view text, double height);

}  // namespace soms::look
