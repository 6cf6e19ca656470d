/// \file
/// From where shadows are cast: the two views of the sun that a picture takes. Private to the
/// renderer.
#pragma once

#include "soms/base/box.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"
#include "apps/view/drawing/gl/gl_view.h"

#include <array>

namespace soms::view {

/// What the sun sees of a ball: a square map, and how far along its rays surfaces are.
struct SunMap {
  Vec3 center;        ///< of the ball, in the world
  double radius = 1;  ///< of the ball, in the world
  /// From device coordinates to [0, 1] in each direction, for what is inside the ball; the third is
  /// 1 toward the sun. Column by column.
  std::array<float, 16> place{};
  float texel = 0;  ///< side of a texel in device coordinates
};

/// Texels along a side of a map.
inline constexpr int kSunTexels = 3072;

/// A map about the camera's target, and one about what else of `scene` the camera sees. Where the
/// scene is not much larger than what is looked at, both are of all of it.
[[nodiscard]] std::array<SunMap, 2> sun_maps(const Camera& camera, const GlView& view,
                                             const Light& light, const Box& scene);

/// The map of the same ball seen from another camera.
[[nodiscard]] SunMap seen_by(const SunMap& map, const GlView& view, const Light& light);

/// True if the balls of two maps differ by rounding at most.
[[nodiscard]] bool same_ball(const SunMap& a, const SunMap& b);

/// False only if nothing in the box can throw a shadow into the ball.
[[nodiscard]] bool casts_into(const SunMap& map, const Light& light, const Box& box);

}  // namespace soms::view
