#include "apps/draw/canvas.h"

#include "apps/draw/picture_marks.h"

#include <cmath>
#include <limits>

namespace soms::look {

namespace {

constexpr std::size_t kFiner = 2;  // pixels of the canvas along one of the picture
constexpr double kCanvasAmbient = 0.58;
constexpr double kGlass = 0.4;          // how much of its own color glass has
constexpr double kThroughAround = 0.6;  // how much is seen through what is around
constexpr double kLineShade = 0.62;

/// Which way a surface faces, in steps: faces of one plane have the same number.
std::uint16_t facing(const Vec3& normal) {
  const auto step = [](double part) {
    return static_cast<std::uint16_t>(std::floor(part * 7 + 7.5));  // 0 to 14
  };
  return static_cast<std::uint16_t>(step(normal.x) + 16 * step(normal.y) + 256 * step(normal.z));
}

}  // namespace

Canvas::Canvas(Size size, const Eye& eye, Rgb paper)
    : size_(size),
      width_(kFiner * static_cast<std::size_t>(size.width)),
      height_(kFiner * static_cast<std::size_t>(size.height)),
      eye_(eye),
      paper_(color_of(paper)),
      layers_{DepthGrid({.columns = width_, .rows = height_}),
              DepthGrid({.columns = width_, .rows = height_}),
              DepthGrid({.columns = width_, .rows = height_})} {
}

void Canvas::draw(const Triangle& triangle, double nearest, const CanvasPaint& paint) {
  Vec3 normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const double size = std::sqrt(dot(normal, normal));
  if (!(size > 0) || !std::isfinite(size)) {
    return;
  }
  // Whichever way it was wound.
  normal = normal * (dot(normal, eye_.frame.forward) > 0 ? -1 / size : 1 / size);
  const double light = brightness(eye_.frame, normal, eye_.frame.forward, kCanvasAmbient);
  // What is left of the triangle beyond the plane z = nearest: at most four corners.
  const std::array<Vec3, 3> corners{eye_.see(triangle.a), eye_.see(triangle.b),
                                    eye_.see(triangle.c)};
  const auto place = [&](const Vec3& seen) {
    return eye_.place(seen, static_cast<double>(width_), static_cast<double>(height_));
  };
  std::array<Vec3, 4> kept{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = corners[k];
    const Vec3& to = corners[(k + 1) % 3];
    if (from.z >= nearest) {
      kept[count++] = place(from);
    }
    if ((from.z >= nearest) != (to.z >= nearest)) {
      const double share = (nearest - from.z) / (to.z - from.z);
      kept[count++] =
          place({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), nearest});
    }
  }
  if (count < 3) {
    return;
  }
  const auto number = static_cast<std::uint32_t>(faces_.size());
  faces_.push_back({.color = lit(color_of(paint.color), light),
                    .key = static_cast<std::uint16_t>(facing(normal) ^ paint.object << 12U)});
  for (std::size_t k = 2; k < count; ++k) {
    layers_[static_cast<std::size_t>(paint.layer)].draw(kept[0], kept[k - 1], kept[k], number);
  }
}

void Canvas::mark(const Vec3& place, double radius, Rgb color, Rgb halo) {
  const Vec3 seen = eye_.see(place);
  if (seen.z > 0) {
    const Vec3 at = eye_.place(seen, size_.width, size_.height);
    marks_.push_back({{at.x, at.y}, radius, color_of(color), color_of(halo)});
  }
}

std::uint16_t Canvas::key_of(std::uint32_t face) const {
  return face == DepthGrid::kNothing ? std::uint16_t{0} : faces_[face].key;
}

Canvas::Sample Canvas::sample(CanvasLayer layer, std::size_t x, std::size_t y) const {
  const DepthGrid& grid = layers_[static_cast<std::size_t>(layer)];
  const std::size_t at = y * width_ + x;
  const std::uint32_t face = grid.shown()[at];
  if (face == DepthGrid::kNothing) {
    return {paper_, std::numeric_limits<double>::infinity()};
  }
  const auto differs = [&](std::size_t other) {
    return key_of(grid.shown()[other]) != faces_[face].key;
  };
  const bool is_line =
      (x + 1 < width_ && differs(at + 1)) || (y + 1 < height_ && differs(at + width_));
  const Color& color = faces_[face].color;
  return {is_line ? lit(color, kLineShade) : color, grid.depths()[at]};
}

Color Canvas::color_at(std::size_t x, std::size_t y) const {
  const Sample around = sample(CanvasLayer::around, x, y);
  const Sample solid = sample(CanvasLayer::solid, x, y);
  const Sample glass = sample(CanvasLayer::glass, x, y);
  const auto through_around = [&](double depth) {
    return depth <= around.depth ? 1 : kThroughAround;
  };
  Color color = around.color;
  if (std::isfinite(solid.depth)) {
    color = mixed(color, solid.color, through_around(solid.depth));
  }
  if (std::isfinite(glass.depth) && glass.depth <= solid.depth) {
    color = mixed(color, glass.color, through_around(glass.depth) * kGlass);
  }
  return color;
}

Picture Canvas::picture() const {
  Picture picture = filled(size_, paper_);
  for (int y = 0; y < size_.height; ++y) {
    for (int x = 0; x < size_.width; ++x) {
      std::array<Color, kFiner * kFiner> samples;
      for (std::size_t k = 0; k < samples.size(); ++k) {
        samples[k] = color_at(kFiner * static_cast<std::size_t>(x) + k % kFiner,
                              kFiner * static_cast<std::size_t>(y) + k / kFiner);
      }
      picture.put(x, y, mean_of(samples));
    }
  }
  for (const Mark& mark : marks_) {
    draw_mark(picture, mark.middle, mark.radius, mark.color, mark.halo);
  }
  return picture;
}

}  // namespace soms::look
