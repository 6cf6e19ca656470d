#include "apps/view/scene/open_side.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace soms::view {

namespace {

constexpr int kBearings = 12;
constexpr std::array<double, 3> kElevations{0.6, 0.3, 1.1};  ///< radians above the horizon
/// A ray that ends so near to what it was sent to, in parts of its length, has seen it.
constexpr double kSeenSlack = 0.02;

/// Places about the one that is looked at, which a picture of it shows too.
std::array<Vec3, 7> neighborhood(const Vec3& p, double reach) {
  return {p,
          p + Vec3{reach, 0, 0},
          p + Vec3{-reach, 0, 0},
          p + Vec3{0, reach, 0},
          p + Vec3{0, -reach, 0},
          p + Vec3{0, 0, reach},
          p + Vec3{0, 0, 0.5 * reach}};
}

Vec3 direction_of(double bearing, double elevation) {
  return {std::cos(elevation) * std::cos(bearing), std::cos(elevation) * std::sin(bearing),
          std::sin(elevation)};
}

}  // namespace

Vec3 open_side(const ViewScene& scene, const Vec3& place, double reach, double distance) {
  std::vector<Vec3> sides;
  for (const double elevation : kElevations) {
    for (int k = 0; k < kBearings; ++k) {  // from the corner that pictures begin with, and round
      sides.push_back(
          direction_of(-std::numbers::pi / 3 + 2 * std::numbers::pi * k / kBearings, elevation));
    }
  }
  const auto points = neighborhood(place, reach);
  std::vector<Ray> rays;
  for (const Vec3& side : sides) {
    for (const Vec3& point : points) {
      const Vec3 eye = place + side * distance;
      rays.push_back({eye, point - eye});
    }
  }
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  Vec3 best = sides.front();
  double most = -1;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    double seen = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool is_free = hits[s * points.size() + k].t >= 1 - kSeenSlack;
      seen += is_free ? (k == 0 ? 4 : 1) : 0;  // the place itself counts most
    }
    if (seen > most) {
      most = seen;
      best = sides[s];
    }
  }
  return best;
}

}  // namespace soms::view
