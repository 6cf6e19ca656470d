/// \file
/// Pictures in memory: sizes, places and colors of pixels.
#pragma once

#include "apps/draw/look.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::look {

/// Width and height of a picture or window, in pixels.
struct Size {
  int width = 960;
  int height = 540;

  [[nodiscard]] bool operator==(const Size&) const = default;
};

/// A place in a picture, in pixels from its upper left corner; the center of the first is (0.5,
/// 0.5).
struct PixelPoint {
  double x = 0;
  double y = 0;
};

/// Color in sRGB; `a` below 255 is translucent.
struct Color {
  std::uint8_t r = 255;
  std::uint8_t g = 255;
  std::uint8_t b = 255;
  std::uint8_t a = 255;

  [[nodiscard]] bool operator==(const Color&) const = default;
};

/// A color of look.h, opaque.
[[nodiscard]] constexpr Color color_of(Rgb color) {
  return {color.r, color.g, color.b, 255};
}

/// `color` with another opacity.
[[nodiscard]] constexpr Color with_alpha(Color color, std::uint8_t a) {
  color.a = a;
  return color;
}

/// From `from` at 0 to `to` at 1, as opaque as `from`. \pre 0 <= `share` <= 1.
[[nodiscard]] Color mixed(Color from, Color to, double share);

/// A color in so much light: 0 is black, and above 1 it is brighter, up to white. \pre `light` >=
/// 0.
[[nodiscard]] Color lit(Color color, double light);

/// The mean of samples, opaque. \pre There is one.
[[nodiscard]] Color mean_of(std::span<const Color> samples);

/// Red, green, blue and opacity of each pixel, a byte each, rows from top to bottom.
struct Picture {
  Size size{0, 0};
  std::vector<std::uint8_t> bytes;  ///< 4 x width x height

  [[nodiscard]] bool operator==(const Picture&) const = default;

  /// \pre 0 <= x < width, 0 <= y < height.
  [[nodiscard]] Color at(int x, int y) const;

  /// \pre As of `at`.
  void put(int x, int y, Color color);
};

/// A picture of one color.
[[nodiscard]] Picture filled(Size size, Color color);

}  // namespace soms::look
