#include "apps/view/drawing/labels.h"

#include "apps/draw/stroke_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace soms::view {

namespace {

constexpr double kFromLine = 9;    ///< pixels between a label and its segment
constexpr double kFromEdge = 6;    ///< of the picture
constexpr double kBetweenTwo = 4;  ///< labels

/// A segment in a picture.
struct Seen {
  PixelPoint a;
  PixelPoint b;
};

/// The part of a segment in front of the eye.
std::optional<Seen> projected(const Label& label, const Camera& camera, Size size) {
  const Vec3 forward = frame(camera).forward;
  Vec3 a = label.a;
  Vec3 b = label.b;
  const double depth_a = dot(a - camera.eye, forward);
  const double depth_b = dot(b - camera.eye, forward);
  const double least = 1e-6 * std::max(depth_a, depth_b);
  if (!(least > 0)) {
    return std::nullopt;
  }
  if (depth_a < least || depth_b < least) {
    (depth_a < least ? a : b) = a + (b - a) * ((least - depth_a) / (depth_b - depth_a));
  }
  const auto seen_a = project(camera, size, a);
  const auto seen_b = project(camera, size, b);
  if (!seen_a || !seen_b) {
    return std::nullopt;
  }
  return Seen{seen_a->pixel, seen_b->pixel};
}

/// The part inside the picture (Liang and Barsky 1984).
std::optional<Seen> cut_to(Size size, const Seen& seen) {
  const double dx = seen.b.x - seen.a.x;
  const double dy = seen.b.y - seen.a.y;
  double from = 0;
  double to = 1;
  const std::array<std::pair<double, double>, 4> sides{{{-dx, seen.a.x},
                                                        {dx, size.width - seen.a.x},
                                                        {-dy, seen.a.y},
                                                        {dy, size.height - seen.a.y}}};
  for (const auto& [step, room] : sides) {
    if (step == 0 && room < 0) {
      return std::nullopt;
    }
    if (step < 0) {
      from = std::max(from, room / step);
    } else if (step > 0) {
      to = std::min(to, room / step);
    }
  }
  if (!(from <= to)) {
    return std::nullopt;
  }
  return Seen{{seen.a.x + dx * from, seen.a.y + dy * from},
              {seen.a.x + dx * to, seen.a.y + dy * to}};
}

/// The direction from a segment to its label: to the right of a steep one, else above it.
PixelPoint side_of(const Seen& seen) {
  const double dx = seen.b.x - seen.a.x;
  const double dy = seen.b.y - seen.a.y;
  const double length = std::hypot(dx, dy);
  if (length < 1) {
    return {0, -1};
  }
  const PixelPoint normal{dy / length, -dx / length};
  const bool steep = std::abs(dy) > std::abs(dx);
  return (steep ? normal.x < 0 : normal.y > 0) ? PixelPoint{-normal.x, -normal.y} : normal;
}

double kept_inside(double at, double half, double whole) {
  const double edge = half + kFromEdge;
  return whole < 2 * edge ? whole / 2 : std::clamp(at, edge, whole - edge);
}

bool apart(const PlacedLabel& a, const PlacedLabel& b) {
  return a.lower_right.x + kBetweenTwo < b.upper_left.x ||
         b.lower_right.x + kBetweenTwo < a.upper_left.x ||
         a.lower_right.y + kBetweenTwo < b.upper_left.y ||
         b.lower_right.y + kBetweenTwo < a.upper_left.y;
}

}  // namespace

std::vector<PlacedLabel> place_labels(std::span<const Label> labels, const Camera& camera,
                                      Size size) {
  std::vector<PlacedLabel> placed;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const auto whole = projected(labels[k], camera, size);
    const auto seen = whole ? cut_to(size, *whole) : std::nullopt;
    if (!seen) {
      continue;
    }
    const double half_width = 0.5 * look::width_of(labels[k].text, labels[k].height);
    const double half_height = 0.5 * labels[k].height;
    const PixelPoint side = side_of(*seen);
    // Just as far that the line through the segment passes the box.
    const double away = std::abs(side.x) * half_width + std::abs(side.y) * half_height + kFromLine;
    const double x =
        kept_inside((seen->a.x + seen->b.x) / 2 + side.x * away, half_width, size.width);
    const double y =
        kept_inside((seen->a.y + seen->b.y) / 2 + side.y * away, half_height, size.height);
    const PlacedLabel here{k, {x - half_width, y - half_height}, {x + half_width, y + half_height}};
    if (std::all_of(placed.begin(), placed.end(),
                    [&](const PlacedLabel& other) { return apart(here, other); })) {
      placed.push_back(here);
    }
  }
  return placed;
}

}  // namespace soms::view
