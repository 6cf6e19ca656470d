#include "apps/view/verbs/stage.h"

#include "apps/view/drawing/length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms::view {

namespace {

/// From the camera's target: to the right, toward the eye, and up.
struct SunPlace {
  double right;
  double back;
  double up;
};

constexpr std::array kSunPlaces{SunPlace{-0.85, 0.2, 0.95},  SunPlace{0.85, 0.2, 0.95},
                                SunPlace{-0.5, 0.6, 0.95},   SunPlace{0.5, 0.6, 0.95},
                                SunPlace{-0.85, -0.4, 0.95}, SunPlace{0.85, -0.4, 0.95},
                                SunPlace{-0.3, 0.2, 1.1},    SunPlace{0.3, 0.2, 1.1}};

/// What is looked at does not hide its own sun: rays begin this part of the way to the eye from it.
constexpr double kOffTarget = 0.12;

}  // namespace

Vec3 sun_for(const Camera& camera, const ViewScene& scene) {
  const CameraFrame f = frame(camera);
  const Vec3 back = cross(f.right, {0, 0, 1});
  std::vector<Ray> rays;
  for (const SunPlace& place : kSunPlaces) {
    const Vec3 toward = f.right * place.right + back * place.back + Vec3{0, 0, place.up};
    const double size = length(toward);
    const Vec3 off = toward * (kOffTarget * distance_to_target(camera) / size);
    rays.push_back({camera.target + off, toward});
  }
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  const auto free = std::find_if(hits.begin(), hits.end(),
                                 [](const SurfaceHit& hit) { return !hit.body.has_value(); });
  const auto chosen = free == hits.end() ? 0 : free - hits.begin();
  return rays[static_cast<std::size_t>(chosen)].direction;
}

double ground_level(const Camera& camera, const ViewScene& scene, double lowest) {
  constexpr std::uint32_t kMost = 1000;
  constexpr double kLittle = 0.05;  // of the scene's height
  constexpr double kBelow = 2e-4;   // of the scene's height: the ground covers no wheels
  const double height = scene.bounds().extent().z;
  std::vector<Ray> rays;
  for (std::uint32_t k = 0; k < std::min(scene.movers(), kMost); ++k) {
    const Box box = scene.bounds(mover(k));
    if (box.lower.z > lowest && box.lower.z < lowest + kLittle * height) {
      rays.push_back({{box.center().x, box.center().y, box.lower.z}, {0, 0, -1}});
    }
  }
  double level = lowest;
  double least = std::numeric_limits<double>::infinity();
  const std::vector<SurfaceHit> hits = scene.first_hits(rays, false);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const Vec3 off = rays[k].origin - camera.target;
    if (!hits[k].body && dot(off, off) < least) {
      least = dot(off, off);
      level = rays[k].origin.z - kBelow * height;
    }
  }
  return level;
}

}  // namespace soms::view
