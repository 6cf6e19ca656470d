#include "apps/soms/clash/clash_canvas.h"

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

Canvas::Point Canvas::seen(const Vec3& at) const {
  const Vec3 v = at - camera_.eye;
  return {dot(v, camera_.right), dot(v, camera_.up), dot(v, camera_.forward)};
}

Canvas::Point Canvas::on_canvas(const Point& seen) const {
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
  const std::array<Point, 3> corners{seen(triangle.a), seen(triangle.b), seen(triangle.c)};
  std::array<Point, 4> kept{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& from = corners[k];
    const Point& to = corners[(k + 1) % 3];
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

void Canvas::fill(const Point& a, const Point& b, const Point& c, const Pixel& paint,
                  Layer& layer) {
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(std::fabs(area) > 0) || !std::isfinite(area)) {
    return;
  }
  const auto column = [](double at, std::size_t most) {
    return static_cast<std::size_t>(
        std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(most)));
  };
  const std::size_t top = column(std::min({a.y, b.y, c.y}), height_);
  const std::size_t bottom = column(std::max({a.y, b.y, c.y}), height_);
  for (std::size_t row = top; row < bottom; ++row) {
    const double y = static_cast<double>(row) + 0.5;
    // Where the row enters and leaves the triangle, and 1 / z there.
    std::array<std::array<double, 2>, 2> ends{};
    std::size_t found = 0;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if ((from.y <= y) != (to.y <= y) && found < 2) {
        const double share = (y - from.y) / (to.y - from.y);
        ends[found++] = {from.x + share * (to.x - from.x), from.z + share * (to.z - from.z)};
      }
    }
    if (found < 2) {
      continue;
    }
    if (ends[0][0] > ends[1][0]) {
      std::swap(ends[0], ends[1]);
    }
    const double slope =
        ends[1][0] > ends[0][0] ? (ends[1][1] - ends[0][1]) / (ends[1][0] - ends[0][0]) : 0;
    const std::size_t last = column(ends[1][0], width_);
    for (std::size_t x = column(ends[0][0], width_); x < last; ++x) {
      const double depth = ends[0][1] + slope * (static_cast<double>(x) + 0.5 - ends[0][0]);
      Pixel& pixel = layer[row * width_ + x];
      if (const auto rounded = static_cast<float>(depth); rounded > pixel.depth) {
        pixel = paint;
        pixel.depth = rounded;
      }
    }
  }
}

void Canvas::mark(const Vec3& place, double radius, look::Rgb color, look::Rgb halo) {
  const Point at = seen(place);
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
