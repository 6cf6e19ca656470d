/// \file
/// A gap as it is drawn: a line between two nearest points, a dot at either end, and its length.
#pragma once

#include "apps/view/drawing/draw_list.h"
#include "apps/view/drawing/palette.h"

#include <string>

namespace soms::view {

/// A shortest segment between two bodies, in world coordinates.
struct GapMark {
  Vec3 point_a = {};
  Vec3 point_b = {};
  std::string length = {};  ///< as it is written beside the line; empty: nothing is
  Color color = palette::kGap;
};

/// Adds the marks of a gap: a line and two dots of constant size in the picture, pale where
/// surfaces hide them, and the length on top of everything. Of lengths that would cover each other
/// the one that was added first is written, so add the nearest first.
void add_gap(DrawList& list, const GapMark& gap);

}  // namespace soms::view
