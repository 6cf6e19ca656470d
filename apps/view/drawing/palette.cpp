#include "apps/view/drawing/palette.h"

#include <algorithm>
#include <array>

namespace soms::view {

Color part_color(std::size_t i) {
  // Body B in lighter and darker, grayer and yellower shades.
  static constexpr std::array<Color, 10> kMuted{{{221, 205, 172, 255},
                                                 {208, 195, 167, 255},
                                                 {230, 218, 190, 255},
                                                 {200, 190, 168, 255},
                                                 {214, 199, 163, 255},
                                                 {222, 212, 193, 255},
                                                 {196, 183, 152, 255},
                                                 {212, 206, 190, 255},
                                                 {235, 225, 203, 255},
                                                 {203, 192, 176, 255}}};
  // A multiplicative hash: buildings that were surveyed one after the other differ.
  return kMuted[(i * 2654435761U >> 7U) % kMuted.size()];
}

Color mover_color(std::size_t i) {
  static constexpr std::array<Color, 6> kStrong{{palette::kBodyA, palette::kOrange, palette::kGreen,
                                                 palette::kSkyBlue, palette::kPurple,
                                                 palette::kYellow}};
  return kStrong[i % kStrong.size()];
}

Color ordered_color(double t) {
  const double at = std::clamp(t, 0.0, 1.0) * (look::kLevels.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), look::kLevels.size() - 2);
  return look::mixed(color_of(look::kLevels[i]), color_of(look::kLevels[i + 1]),
                     at - static_cast<double>(i));
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
