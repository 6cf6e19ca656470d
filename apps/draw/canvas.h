/// \file
/// A canvas with depth: triangles in perspective, flat shaded, with their outlines.
#pragma once

#include "soms/base/vector.h"

#include "apps/draw/depth_grid.h"
#include "apps/draw/eye.h"
#include "apps/draw/picture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::look {

/// What hides what.
enum class CanvasLayer : unsigned char {
  around,  ///< where it is before the others, they shine through
  solid,   ///< hides what is behind it
  glass,   ///< one sees through its nearest surface
};

/// How a triangle is painted.
struct CanvasPaint {
  Rgb color;
  std::uint16_t object = 1;  ///< lines are drawn between objects; below 16
  CanvasLayer layer = CanvasLayer::around;
};

/// Draws at twice the size of the picture that it gives.
class Canvas {
 public:
  Canvas(Size size, const Eye& eye, Rgb paper);

  /// What is nearer than `nearest`, measured along the direction of sight, is left out.
  void draw(const Triangle& triangle, double nearest, const CanvasPaint& paint);

  /// A disc with a halo, in front of all. \param radius In pixels of the picture.
  void mark(const Vec3& place, double radius, Rgb color, Rgb halo);

  [[nodiscard]] Picture picture() const;

 private:
  /// What a drawn triangle looks like.
  struct Face {
    Color color;
    std::uint16_t key = 0;  ///< of object and facing; 0 is of none
  };

  /// A layer's color at a sample, and how near it is there.
  struct Sample {
    Color color;
    double depth;
  };

  [[nodiscard]] std::uint16_t key_of(std::uint32_t face) const;
  [[nodiscard]] Sample sample(CanvasLayer layer, std::size_t x, std::size_t y) const;
  [[nodiscard]] Color color_at(std::size_t x, std::size_t y) const;

  Size size_;
  std::size_t width_;
  std::size_t height_;
  Eye eye_;
  Color paper_;
  std::vector<Face> faces_;
  std::array<DepthGrid, 3> layers_;  ///< by CanvasLayer

  struct Mark {
    PixelPoint middle;
    double radius;
    Color color;
    Color halo;
  };

  std::vector<Mark> marks_;
};

}  // namespace soms::look
