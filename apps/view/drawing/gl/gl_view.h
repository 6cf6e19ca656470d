/// \file
/// One frame's view as the device gets it: everything relative to the eye. Private to the renderer.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <array>
#include <cstdint>

namespace soms::view {

/// Whether depths run from 1 near the eye to 0 far off, which keeps precision at every distance, or
/// as OpenGL 3.3 alone has them.
enum class DepthMode : std::uint8_t { reversed, plain };

/// As floats.
[[nodiscard]] std::array<float, 3> narrow(const Vec3& v);

/// Red, green and blue from 0 to 1, opaque.
[[nodiscard]] std::array<float, 4> parts_of(Color c);

/// A view. Device coordinates are `(world - eye) * unit`: differences are made in double, and
/// whatever the model's unit is, the numbers are near 1.
struct GlView {
  Vec3 eye;
  double unit = 1;
  std::array<float, 16> clip{};   ///< from device coordinates, column by column
  float nearest = 0;              ///< least clip w that is drawn
  float half_width = 0;           ///< of the picture, in pixels
  float half_height = 0;          ///< of the picture, in pixels
  float slope = 0;                ///< width of a pixel at distance 1
  float point = 1;                ///< pixels of a point, in which widths of strokes are given
  float lift = 1;                 ///< factor that brings overlays nearer than their surfaces
  std::array<float, 3> toward{};  ///< unit vector to the light
  std::array<float, 3> above{};   ///< the world's up
  float ambient = 0;
  std::array<float, 3> right{};    ///< of the picture
  std::array<float, 3> upward{};   ///< of the picture
  std::array<float, 3> forward{};  ///< into the picture
  std::array<float, 2> slopes{};   ///< half of the picture's width and height at distance 1
  /// Factor and summand that take a depth of the device to 1 / (distance forward).
  std::array<float, 2> inverse_depth{};

  /// A point in device coordinates.
  [[nodiscard]] std::array<float, 3> relative(const Vec3& p) const;

  /// A length in device coordinates.
  [[nodiscard]] float length(double of_world) const { return static_cast<float>(of_world * unit); }
};

/// \pre `size` is at least 1x1.
[[nodiscard]] GlView gl_view(const Camera& camera, Size size, const Light& light,
                             const DepthRange& range, DepthMode mode);

/// Rows of `[R | t]` from coordinates of a tile or a group, `origin + scale * p` of a body, to
/// device coordinates.
[[nodiscard]] std::array<float, 12> relative_rows(const GlView& view, const Pose& pose,
                                                  const Vec3& origin, double scale);

}  // namespace soms::view
