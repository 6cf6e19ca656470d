#include "apps/view/scene/aim.h"

#include "soms/base/common_box.h"

#include "apps/view/drawing/length.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace soms::view {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// What is seen less than this of a contact is looked at with what is before it cut away.
constexpr double kHidden = 0.15;

/// Places on the curves of contacts, evenly over their list.
std::vector<Vec3> places_of(const std::vector<Touch>& touches, const ViewScene& scene) {
  constexpr std::size_t kMost = 24;
  std::vector<Vec3> places;
  const std::size_t count = std::min(touches.size(), kMost);
  for (std::size_t k = 0; k < count; ++k) {
    const CommonPoints crossing = scene.common_points(touches[k * touches.size() / count]);
    const auto points = crossing.points();
    Vec3 sum;
    for (const Vec3& p : points) {
      sum += p * (1 / static_cast<double>(points.size()));
    }
    if (!points.empty()) {
      places.push_back(sum);
    }
  }
  return places;
}

/// Bounds of the parts of a body that touch anything.
Box touching_box(BodyRef body, const std::vector<Touch>& touches, PartBoxes& part_boxes) {
  Box box;
  for (const Touch& touch : touches) {
    box.grow(part_boxes(body, touch.a == body ? touch.i : touch.j));
  }
  return box;
}

/// A camera, and the share of what must not be hidden that it sees, 0 to 1.
struct Aimed {
  Camera camera;
  double free = 0;
};

/// Share of an aim's points that a camera sees. The body that is looked at does not hide its own
/// middle; it hides points on it that are farther than a small part of its size behind its surface.
/// From an eye with a roof above it, as in a house, a third of that.
double seen_share(const Aim& aim, const Camera& camera, const ViewScene& scene) {
  constexpr double kThin = 0.02;
  constexpr double kUnderRoof = 1.0 / 3;
  if (aim.points.empty()) {
    return 0;
  }
  const Vec3 forward = frame(camera).forward;
  std::vector<Ray> rays;
  for (const Vec3& point : aim.points) {
    const Vec3 line = point - camera.eye;
    const Vec3 start = camera.eye + line * (camera.cut / dot(line, forward));
    rays.push_back({start, point - start});
  }
  rays.push_back({camera.eye, {0, 0, 1}});
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  const double thin = kThin * diagonal(aim.around);
  std::size_t seen = 0;
  for (std::size_t k = 0; k < aim.points.size(); ++k) {
    const double whole = length(rays[k].direction);
    const bool own = aim.is_middle && hits[k].body == aim.body;
    seen += own || hits[k].t * whole > whole - thin ? 1U : 0U;
  }
  return (hits.back().body ? kUnderRoof : 1.0) * static_cast<double>(seen) /
         static_cast<double>(aim.points.size());
}

/// Share of the sky that is free above a subject: 1 in the open, little in a yard, 0 indoors.
double open_sky(const Aim& aim, const ViewScene& scene) {
  constexpr int kAround = 8;
  const Vec3 center = aim.around.center();
  const Vec3 above{center.x, center.y, aim.around.upper.z + 0.1 * diagonal(aim.around)};
  std::vector<Ray> rays{{above, {0, 0, 1}}};
  for (int k = 0; k < kAround; ++k) {
    rays.push_back({above, toward_eye(360.0 * k / kAround, 40)});
  }
  const std::vector<SurfaceHit> hits = scene.first_hits(rays);
  const auto free = std::count_if(hits.begin(), hits.end(),
                                  [](const SurfaceHit& hit) { return !hit.body.has_value(); });
  return static_cast<double>(free) / static_cast<double>(hits.size());
}

/// Distance from the eye at which a box begins.
double front_of(const Box& box, const Camera& camera) {
  const Vec3 forward = frame(camera).forward;
  const Vec3 half = box.extent() * 0.5;
  return dot(box.center() - camera.eye, forward) - std::abs(forward.x) * half.x -
         std::abs(forward.y) * half.y - std::abs(forward.z) * half.z;
}

/// A camera on the subject's surroundings, from the side from which most of what matters is seen;
/// of sides that are about alike the first. With `cut` what lies before the surroundings is left
/// out.
Aimed aimed(const ViewScene& scene, const Aim& aim, const Sides& sides, const FitCamera& fit,
            bool cut, const Limits& limits) {
  constexpr double kAimSurroundings = 1.5;  // half of the picture's box, in extents of the subject
  constexpr double kMuchBetter = 0.2;
  const Vec3 half = aim.around.extent() * kAimSurroundings;
  const Vec3 center = aim.around.center();
  const Box wide = common_box({center - half, center + half}, scene_bounds(scene));
  const auto from = [&](double bearing, double elevation) {
    Camera camera = fit(wide, toward_eye(bearing, elevation));
    camera.cut = cut ? std::max(0.0, front_of(aim.around, camera)) : 0.0;
    return Aimed{camera, seen_share(aim, camera, scene)};
  };
  Aimed best = from(sides.bearing, sides.elevation);
  if (!sides.all_around) {
    return best;
  }
  best.free = -1;
  for (const double elevation : {25.0, 45.0, 65.0}) {
    for (int turn = 0; turn < 16; ++turn) {
      check_stop(limits);
      const Aimed here = from(sides.bearing + 22.5 * turn, elevation);
      if (here.free > best.free + kMuchBetter || best.free < 0) {
        best = here;
      }
    }
  }
  return best;
}

/// Of many aims the one that is seen well, from a single side that is not hidden, the first such;
/// else the one that is seen best.
std::pair<Aimed, Box> best_of(const ViewScene& scene, std::span<const Aim> aims, const Sides& sides,
                              const FitCamera& fit, bool cut, const Limits& limits) {
  constexpr double kWell = 0.45;    // of its curve, whose rear the mover itself hides
  constexpr double kIndoors = 0.2;  // what a contact indoors counts
  const double enough = sides.all_around ? kWell : kHidden;
  std::pair<Aimed, Box> best;
  best.first.free = -2;
  for (const Aim& aim : aims) {
    Aimed here = aimed(scene, aim, sides, fit, cut, limits);
    here.free *= cut ? 1 : kIndoors + (1 - kIndoors) * open_sky(aim, scene);
    if (here.free > best.first.free) {
      best = {here, aim.around};
    }
    if (best.first.free >= enough) {
      break;
    }
  }
  return best;
}

}  // namespace

Aim aim_at_touches(const ViewScene& scene, BodyRef body, const std::vector<Touch>& touches,
                   PartBoxes& part_boxes) {
  return {places_of(touches, scene), touching_box(body, touches, part_boxes), body};
}

AimedCamera aimed_camera(const ViewScene& scene, std::span<const Aim> aims, const Sides& sides,
                         const FitCamera& fit, const Limits& limits) {
  const auto whole = best_of(scene, aims, sides, fit, false, limits);
  if (sides.may_cut && sides.all_around && whole.first.free < kHidden) {
    const auto cut = best_of(scene, aims, sides, fit, true, limits);
    if (cut.first.free > whole.first.free) {
      return {cut.first.camera, cut.second};
    }
  }
  return {whole.first.camera, whole.second};
}

Vec3 toward_eye(double bearing, double elevation) {
  const double level = std::cos(elevation * kDegree);
  return {level * std::sin(bearing * kDegree), level * std::cos(bearing * kDegree),
          std::sin(elevation * kDegree)};
}

Box scene_bounds(const ViewScene& scene) {
  Box box = scene.bounds();
  for (std::uint32_t k = 0; k < scene.movers(); ++k) {
    box.grow(scene.bounds(mover(k)));
  }
  return box;
}

}  // namespace soms::view
