/// \file
/// Why two triangles touch or do not: the step that decided, in numbers and in words.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/common_points.h"
#include "soms/geometry/orientation.h"

#include <array>
#include <string>
#include <string_view>

namespace soms::view {

/// The step that settles a pair; each is tried only when those before it left the pair open.
enum class Stage {
  boxes,       ///< their boxes are apart along an axis
  plane_of_b,  ///< all corners of the first lie strictly on one side of the second's plane
  plane_of_a,  ///< the mirror image
  edges,       ///< general position: the pieces of the planes' common line meet, or do not
  coplanar,    ///< both lie in one plane, where edges separate them or not
  flat,        ///< one of them has no area: it is a segment or a point
};

/// How two triangles meet.
enum class TouchKind {
  none,
  crossing,      ///< each has points on both sides of the other near a common one
  touching,      ///< they meet, but no point of one lies beyond the other there
  common_area,   ///< in one plane, with an area in common
  without_area,  ///< one of them is a segment or a point
};

/// A height of a corner above the plane of the other triangle, and its exact sign.
struct CornerSide {
  Sign sign = Sign::zero;
  double height = 0;  ///< rounded; its own sign may be wrong where the exact one says zero
};

/// Why two triangles touch or do not. `touch` and all signs are exact; lengths are rounded.
struct Explanation {
  bool touch = false;
  Stage stage = Stage::boxes;
  TouchKind kind = TouchKind::none;
  std::size_t axis = 0;                 ///< of Stage::boxes: the axis of the widest gap
  double gap = 0;                       ///< and its width
  std::array<CornerSide, 3> a_above_b;  ///< corners of the first against the second's plane
  std::array<CornerSide, 3> b_above_a;
  bool exact_arithmetic = false;  ///< a sign was too close to zero for plain doubles
  CommonPoints common;            ///< what they have in common
  std::string text;               ///< some sentences for people, without a line break at the end
};

/// Explains a pair of world triangles.
/// \pre  As for `triangles_overlap`, with whose answer `touch` agrees.
[[nodiscard]] Explanation explain(const Triangle& a, const Triangle& b);

[[nodiscard]] std::string_view name(Stage stage);
[[nodiscard]] std::string_view name(TouchKind kind);

}  // namespace soms::view
