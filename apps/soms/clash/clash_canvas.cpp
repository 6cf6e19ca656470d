#include "apps/soms/clash/clash_canvas.h"

#include "apps/draw/raster.h"

#include <algorithm>
#include <cmath>

namespace soms::command {

namespace {

constexpr std::size_t kFiner = 2;       // pixels of the canvas along one of the picture
constexpr double kGlass = 0.4;          // how much of its own color glass has
constexpr double kThroughAround = 0.6;  // how much is seen through what is around
constexpr double kLineShade = 0.62;
constexpr double kHaloWidth = 1.6;  // of a mark's radius

/// `share` is from 0 to 1.
std::uint8_t mixed(double a, double b, double share) {
  return static_cast<std::uint8_t>(a + (b - a) * share + 0.5);
}

look::Rgb mixed(look::Rgb a, look::Rgb b, double share) {
  return {mixed(a.r, b.r, share), mixed(a.g, b.g, share), mixed(a.b, b.b, share)};
}

/// Which way a surface faces, in steps: faces of one plane have the same number.
std::uint16_t facing(const Vec3& normal) {
  const auto step = [](double part) {
    return static_cast<std::uint16_t>(std::floor(part * 7 + 7.5));  // 0 to 14
  };
  return static_cast<std::uint16_t>(step(normal.x) + 16 * step(normal.y) + 256 * step(normal.z));
}

}  // namespace

Canvas::Canvas(std::size_t width, std::size_t height, const CanvasCamera& camera, look::Rgb paper)
    : width_(kFiner * width),
      height_(kFiner * height),
      camera_(camera),
      paper_(paper),
      layers_{Layer(width_ * height_), Layer(width_ * height_), Layer(width_ * height_)} {
}

Vec3 Canvas::seen(const Vec3& at) const {
  const Vec3 v = at - camera_.eye;
  return {dot(v, camera_.right), dot(v, camera_.up), dot(v, camera_.forward)};
}

Vec3 Canvas::on_canvas(const Vec3& seen) const {
  const double scale = 0.5 * static_cast<double>(height_) / (camera_.tangent * seen.z);
  return {0.5 * static_cast<double>(width_) + seen.x * scale,
          0.5 * static_cast<double>(height_) - seen.y * scale, 1 / seen.z};
}

void Canvas::draw(const Triangle& triangle, double nearest, const CanvasPaint& paint) {
  Vec3 normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  const double size = std::sqrt(dot(normal, normal));
  if (!(size > 0) || !std::isfinite(size)) {
    return;
  }
  normal = normal * (1 / size);
  if (dot(normal, camera_.forward) > 0) {
    normal = -normal;  // whichever way it was wound
  }
  const Vec3 sun = 0.3 * camera_.right + 0.65 * camera_.up - 0.7 * camera_.forward;  // about a unit
  const double light = 0.58 + 0.42 * std::clamp(dot(normal, sun), 0.0, 1.0);
  const Pixel pixel{.color = mixed(look::Rgb{}, paint.color, light),
                    .key = static_cast<std::uint16_t>(facing(normal) ^ paint.object << 12U)};
  // What is left of the triangle beyond the plane z = nearest: at most four corners.
  const std::array<Vec3, 3> corners{seen(triangle.a), seen(triangle.b), seen(triangle.c)};
  std::array<Vec3, 4> kept{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = corners[k];
    const Vec3& to = corners[(k + 1) % 3];
    if (from.z >= nearest) {
      kept[count++] = on_canvas(from);
    }
    if ((from.z >= nearest) != (to.z >= nearest)) {
      const double share = (nearest - from.z) / (to.z - from.z);
      kept[count++] =
          on_canvas({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), nearest});
    }
  }
  for (std::size_t k = 2; k < count; ++k) {
    fill(kept[0], kept[k - 1], kept[k], pixel, layers_[static_cast<std::size_t>(paint.layer)]);
  }
}

void Canvas::fill(const Vec3& a, const Vec3& b, const Vec3& c, const Pixel& paint, Layer& layer) {
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(std::fabs(area) > 0) || !std::isfinite(area)) {
    return;
  }
  for_each_sample({.columns = width_, .rows = height_}, a, b, c,
                  [&](std::size_t x, std::size_t y, double depth) {
                    Pixel& pixel = layer[y * width_ + x];
                    if (const auto rounded = static_cast<float>(depth); rounded > pixel.depth) {
                      pixel = paint;
                      pixel.depth = rounded;
                    }
                  });
}

void Canvas::mark(const Vec3& place, double radius, look::Rgb color, look::Rgb halo) {
  const Vec3 at = seen(place);
  if (at.z > 0) {
    marks_.push_back({on_canvas(at), radius * kFiner, color, halo});
  }
}

look::Rgb Canvas::painted(CanvasLayer which, std::size_t x, std::size_t y) const {
  const Layer& pixels = layer(which);
  const Pixel& here = pixels[y * width_ + x];
  const bool is_line = (x + 1 < width_ && pixels[y * width_ + x + 1].key != here.key) ||
                       (y + 1 < height_ && pixels[(y + 1) * width_ + x].key != here.key);
  return is_line ? mixed(look::Rgb{}, here.color, kLineShade) : here.color;
}

look::Rgb Canvas::scene_at(std::size_t x, std::size_t y) const {
  const std::size_t at = y * width_ + x;
  const float around = layer(CanvasLayer::around)[at].depth;
  const float solid = layer(CanvasLayer::solid)[at].depth;
  const float glass = layer(CanvasLayer::glass)[at].depth;
  look::Rgb color = around > 0 ? painted(CanvasLayer::around, x, y) : paper_;
  if (solid > 0) {
    color = mixed(color, painted(CanvasLayer::solid, x, y), solid >= around ? 1 : kThroughAround);
  }
  if (glass > 0 && glass >= solid) {
    const double share = (glass >= around ? 1 : kThroughAround) * kGlass;
    color = mixed(color, painted(CanvasLayer::glass, x, y), share);
  }
  return color;
}

look::Rgb Canvas::color_at(std::size_t x, std::size_t y) const {
  for (const Mark& mark : marks_) {
    const double across = static_cast<double>(x) + 0.5 - mark.middle.x;
    const double down = static_cast<double>(y) + 0.5 - mark.middle.y;
    const double away = across * across + down * down;
    const double halo = kHaloWidth * mark.radius;
    if (away < halo * halo) {
      return away < mark.radius * mark.radius ? mark.color : mark.halo;
    }
  }
  return scene_at(x, y);
}

RgbPicture Canvas::picture() const {
  RgbPicture picture{.width = width_ / kFiner, .height = height_ / kFiner};
  picture.rgb.reserve(3 * picture.width * picture.height);
  for (std::size_t y = 0; y < height_; y += kFiner) {
    for (std::size_t x = 0; x < width_; x += kFiner) {
      std::array<unsigned, 3> sum{};
      for (std::size_t k = 0; k < kFiner * kFiner; ++k) {
        const look::Rgb color = color_at(x + k % kFiner, y + k / kFiner);
        sum[0] += color.r;
        sum[1] += color.g;
        sum[2] += color.b;
      }
      for (const unsigned part : sum) {
        picture.rgb.push_back(static_cast<std::uint8_t>((part + 2) / (kFiner * kFiner)));
      }
    }
  }
  return picture;
}

}  // namespace soms::command
