#include "apps/view/drawing/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace soms::view {

namespace {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

}  // namespace

Color part_color(std::size_t i) {
  // Stone, sand, slate and the like: near gray, distinguished by lightness as much as by hue.
  static constexpr std::array<Color, 10> kMuted{{{198, 192, 180, 255},
                                                 {170, 178, 186, 255},
                                                 {214, 204, 184, 255},
                                                 {184, 184, 192, 255},
                                                 {160, 172, 168, 255},
                                                 {206, 200, 200, 255},
                                                 {176, 170, 158, 255},
                                                 {192, 200, 206, 255},
                                                 {222, 216, 204, 255},
                                                 {168, 164, 170, 255}}};
  // A multiplicative hash: buildings that were surveyed one after the other differ.
  return kMuted[(i * 2654435761U >> 7U) % kMuted.size()];
}

Color mover_color(std::size_t i) {
  static constexpr std::array<Color, 6> kStrong{{palette::kBlue, palette::kOrange, palette::kGreen,
                                                 palette::kSkyBlue, palette::kPurple,
                                                 palette::kYellow}};
  return kStrong[i % kStrong.size()];
}

Color ordered_color(double t) {
  // Lightness rises steadily from end to end, so the order shows without hue.
  struct Stop {
    double r, g, b;
  };

  static constexpr std::array<Stop, 5> kStops{
      {{32, 40, 100}, {45, 98, 148}, {40, 148, 140}, {130, 196, 92}, {240, 226, 70}}};
  const double at = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double f = at - static_cast<double>(i);
  const Stop& a = kStops[i];
  const Stop& b = kStops[i + 1];
  return {to_byte(a.r + (b.r - a.r) * f), to_byte(a.g + (b.g - a.g) * f),
          to_byte(a.b + (b.b - a.b) * f), 255};
}

std::vector<Color> colors_by_part(const Mesh& mesh) {
  std::vector<Color> colors(mesh.triangles.size(), part_color(0));
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    const Part& part = mesh.parts[p];
    std::fill_n(colors.begin() + static_cast<std::ptrdiff_t>(part.first), part.count,
                part_color(p));
  }
  return colors;
}

}  // namespace soms::view
