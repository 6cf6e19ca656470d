#include "apps/draw/picture_marks.h"

#include "apps/draw/stroke_font.h"

#include <algorithm>
#include <cmath>

namespace soms::look {

namespace {

/// Part of the pen's width in the height of digits.
constexpr double kPenOfHeight = 0.13;
/// Radius of a halo in that of its mark.
constexpr double kHaloOfMark = 1.4;

void blend(Picture& picture, int x, int y, Color color, double cover) {
  picture.put(x, y, mixed(picture.at(x, y), color, cover * color.a / 255));
}

int clamped(double at, int most) {
  return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most)));
}

/// Colors the pixels of a box by how much of them is covered: 1 or less, by the distance of their
/// centers from the edge of a shape, positive inside.
template <class Inside>
void fill(Picture& picture, PixelPoint lower, PixelPoint upper, Color color, const Inside& inside) {
  const int left = clamped(std::floor(lower.x - 1), picture.size.width);
  const int right = clamped(std::ceil(upper.x + 1), picture.size.width);
  const int top = clamped(std::floor(lower.y - 1), picture.size.height);
  const int bottom = clamped(std::ceil(upper.y + 1), picture.size.height);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const double cover = std::clamp(inside(x + 0.5, y + 0.5) + 0.5, 0.0, 1.0);
      if (cover > 0) {
        blend(picture, x, y, color, cover);
      }
    }
  }
}

}  // namespace

void draw_disc(Picture& picture, PixelPoint center, double radius, Color color) {
  draw_line(picture, center, center, 2 * radius, color);
}

void draw_mark(Picture& picture, PixelPoint center, double radius, Color color, Color halo) {
  draw_disc(picture, center, kHaloOfMark * radius, halo);
  draw_disc(picture, center, radius, color);
}

void draw_line(Picture& picture, PixelPoint from, PixelPoint to, double width, Color color) {
  const double radius = width / 2;
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double square = dx * dx + dy * dy;
  fill(picture, {std::min(from.x, to.x) - radius, std::min(from.y, to.y) - radius},
       {std::max(from.x, to.x) + radius, std::max(from.y, to.y) + radius}, color,
       [&](double x, double y) {
         const double along = (x - from.x) * dx + (y - from.y) * dy;
         const double share = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
         return radius - std::hypot(x - from.x - share * dx, y - from.y - share * dy);
       });
}

void draw_rectangle(Picture& picture, PixelPoint from, PixelPoint to, Color color) {
  const PixelPoint lower{std::min(from.x, to.x), std::min(from.y, to.y)};
  const PixelPoint upper{std::max(from.x, to.x), std::max(from.y, to.y)};
  fill(picture, lower, upper, color, [&](double x, double y) {
    return std::min(std::min(x - lower.x, upper.x - x), std::min(y - lower.y, upper.y - y));
  });
}

void draw_number(Picture& picture, PixelPoint start, std::string_view text, double height,
                 Color color) {
  for (const TextStroke& stroke : strokes_of(text, height)) {
    draw_line(picture, {start.x + stroke.from.x, start.y - stroke.from.y},
              {start.x + stroke.to.x, start.y - stroke.to.y}, kPenOfHeight * height, color);
  }
}

}  // namespace soms::look
