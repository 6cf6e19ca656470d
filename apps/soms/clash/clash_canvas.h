/// \file
/// A canvas with depth: triangles in perspective, flat shaded, with their outlines.
#pragma once

#include "soms/base/vector.h"

#include "apps/draw/look.h"
#include "apps/output/png_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::command {

/// Where a camera stands and what it sees. All sides are unit vectors, at right angles.
struct CanvasCamera {
  Vec3 eye = {};
  Vec3 forward = {};
  Vec3 right = {};
  Vec3 up = {};
  double tangent = 1;  ///< of half the angle at which the picture's height is seen
};

/// What hides what.
enum class CanvasLayer : unsigned char {
  around,  ///< where it is before the others, they shine through
  solid,   ///< hides what is behind it
  glass,   ///< one sees through its nearest surface
};

/// How a triangle is painted.
struct CanvasPaint {
  look::Rgb color;
  std::uint16_t object = 1;  ///< lines are drawn between objects; below 16
  CanvasLayer layer = CanvasLayer::around;
};

/// Draws at twice the size of the picture that it gives.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height, const CanvasCamera& camera, look::Rgb paper);

  /// What is nearer than `nearest`, measured along the direction of sight, is left out.
  void draw(const Triangle& triangle, double nearest, const CanvasPaint& paint);

  /// A disc with a halo, in front of all.
  void mark(const Vec3& place, double radius, look::Rgb color, look::Rgb halo);

  [[nodiscard]] RgbPicture picture() const;

 private:
  struct Pixel {
    float depth = 0;  ///< 1 / distance; 0: nothing
    look::Rgb color = {};
    std::uint16_t key = 0;  ///< of object and facing
  };

  using Layer = std::vector<Pixel>;

  [[nodiscard]] Vec3 seen(const Vec3& at) const;
  [[nodiscard]] Vec3 on_canvas(const Vec3& seen) const;
  void fill(const Vec3& a, const Vec3& b, const Vec3& c, const Pixel& paint, Layer& layer);
  [[nodiscard]] look::Rgb painted(CanvasLayer layer, std::size_t x, std::size_t y) const;
  [[nodiscard]] look::Rgb scene_at(std::size_t x, std::size_t y) const;
  [[nodiscard]] look::Rgb color_at(std::size_t x, std::size_t y) const;

  [[nodiscard]] const Layer& layer(CanvasLayer which) const {
    return layers_[static_cast<std::size_t>(which)];
  }

  std::size_t width_;
  std::size_t height_;
  CanvasCamera camera_;
  look::Rgb paper_;
  std::array<Layer, 3> layers_;  ///< by CanvasLayer

  struct Mark {
    Vec3 middle;  ///< on the canvas
    double radius;
    look::Rgb color;
    look::Rgb halo;
  };

  std::vector<Mark> marks_;
};

}  // namespace soms::command
