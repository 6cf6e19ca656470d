/// \file
/// Marks on a finished picture: lines, discs and numbers, with smooth edges.
#pragma once

#include "apps/draw/picture.h"

#include <string_view>

namespace soms::look {

/// Draws a disc, or what of it is inside the picture. An opacity below 255 lets through what is
/// there.
void draw_disc(Picture& picture, PixelPoint center, double radius, Color color);

/// Marks a place by a disc with a halo, which sets it off from any surface.
void draw_mark(Picture& picture, PixelPoint center, double radius, Color color, Color halo);

/// Draws a straight line of a round pen. \pre `width` > 0.
void draw_line(Picture& picture, PixelPoint from, PixelPoint to, double width, Color color);

/// Fills the rectangle between two corners.
void draw_rectangle(Picture& picture, PixelPoint from, PixelPoint to, Color color);

/// Writes the letters that `strokes_of` has, digits `height` pixels high, from the left end of the
/// base line.
void draw_number(Picture& picture, PixelPoint start, std::string_view text, double height,
                 Color color);

}  // namespace soms::look
