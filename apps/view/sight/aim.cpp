#include "apps/view/sight/aim.h"

#include "soms/base/common_box.h"

#include "apps/view/drawing/length.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
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

/// The second of three lengths by size: of a pipe its thickness.
double middle_extent(const Box& box) {
  const Vec3 e = box.extent();
  return std::max(std::min(e.x, e.y), std::min(std::max(e.x, e.y), e.z));
}

/// Bounds of the parts of a body that touch anything; of long parts, of what is near `places`.
Box touching_box(BodyRef body, const std::vector<Touch>& touches, std::span<const Vec3> places,
                 PartBoxes& part_boxes) {
  constexpr double kOfCurve = 2;
  constexpr double kOfThickness = 2.5;
  Box box;
  double thickest = 0;
  for (const Touch& touch : touches) {
    const Box part = part_boxes(body, touch.a == body ? touch.i : touch.j);
    thickest = std::max(thickest, middle_extent(part));
    box.grow(part);
  }
  Box curve;
  for (const Vec3& place : places) {
    curve.grow(place);
  }
  if (curve.empty()) {
    return box;
  }
  const double room = std::max(kOfCurve * diagonal(curve), kOfThickness * thickest);
  const Vec3 margin{room, room, room};
  const Box near = common_box({curve.lower - margin, curve.upper + margin}, box);
  return near.empty() ? box : near;
}

/// Bounds of the movers that touch, and of the parts of the city; not of those that reach far, such
/// as the ground.
Box whole_box(const ViewScene& scene, const Box& around, const std::vector<Touch>& touches,
              PartBoxes& part_boxes) {
  constexpr double kFar = 5;  // in extents of what is looked at
  Box box;
  for (const Touch& touch : touches) {
    for (const auto& [body, i] : {std::pair(touch.a, touch.i), std::pair(touch.b, touch.j)}) {
      const Box own = body.role == Role::mover ? scene.bounds(body) : part_boxes(body, i);
      if (body.role == Role::mover || diagonal(own) <= kFar * diagonal(around)) {
        box.grow(own);
      }
    }
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
  const bool under_roof = hits.back().body && hits.back().body != aim.body;
  return (under_roof ? kUnderRoof : 1.0) * static_cast<double>(seen) /
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
  // What is looked at is no roof: a pipe goes on above its contact.
  const auto free = std::count_if(hits.begin(), hits.end(), [&](const SurfaceHit& hit) {
    return !hit.body || hit.body == aim.body;
  });
  return static_cast<double>(free) / static_cast<double>(hits.size());
}

/// Distance from the eye at which a box begins.
double front_of(const Box& box, const Camera& camera) {
  const Vec3 forward = frame(camera).forward;
  const Vec3 half = box.extent() * 0.5;
  return dot(box.center() - camera.eye, forward) - std::abs(forward.x) * half.x -
         std::abs(forward.y) * half.y - std::abs(forward.z) * half.z;
}

/// Height of what the city has below the middle of a box; nothing where there is none.
std::optional<double> ground_below(const Box& box, const ViewScene& scene) {
  constexpr int kMostMovers = 8;  // on the way down
  Vec3 from = box.center();
  for (int k = 0; k < kMostMovers; ++k) {
    const Ray down{from, {0, 0, -1}};
    const SurfaceHit hit = scene.first_hits({&down, 1}).front();
    if (!hit.body) {
      break;
    }
    if (hit.body->role == Role::city) {
      return hit.point.z;
    }
    from.z = hit.point.z - 1e-6 * diagonal(box);
  }
  return std::nullopt;
}

/// Distance from the eye, forward, at which the picture begins to show the ground below an aim;
/// infinity where it does not.
double ground_from(const Aim& aim, const std::optional<double>& height, const Camera& camera) {
  constexpr double kRise = 0.5;  // of the ground toward the eye, in heights of the aim
  if (!height) {
    return std::numeric_limits<double>::infinity();
  }
  const CameraFrame axes = frame(camera);
  const double slope = axes.forward.z - std::tan(camera.field_of_view / 2) * axes.up.z;
  const double ground = *height + kRise * aim.around.extent().z;
  return slope < 0 ? std::max(0.0, (ground - camera.eye.z) / slope)
                   : std::numeric_limits<double>::infinity();
}

/// How far from the eye a cut may be: before the bodies that touch, and before all of the ground.
double deepest_cut(const Aim& aim, const std::optional<double>& ground, const Camera& camera) {
  const Box& whole = aim.whole.empty() ? aim.around : aim.whole;
  return std::max(0.0, std::min({front_of(aim.around, camera), front_of(whole, camera),
                                 ground_from(aim, ground, camera)}));
}

/// A camera on the subject's surroundings, from the side from which most of what matters is seen;
/// of sides that are about alike the first. With `cut` what lies before the surroundings is left
/// out.
Aimed aimed(const ViewScene& scene, const Aim& aim, const Sides& sides, const FitCamera& fit,
            bool cut, const Limits& limits) {
  constexpr double kAimSurroundings = 1;  // half of the picture's box, in extents of the subject
  constexpr double kMuchBetter = 0.2;
  const Vec3 half = aim.around.extent() * kAimSurroundings;
  const Vec3 center = aim.around.center();
  const Box wide = common_box({center - half, center + half}, scene_bounds(scene));
  const std::optional<double> ground = cut ? ground_below(aim.around, scene) : std::nullopt;
  const auto from = [&](double bearing, double elevation) {
    Camera camera = fit(wide, toward_eye(bearing, elevation));
    camera.cut = cut ? deepest_cut(aim, ground, camera) : 0.0;
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
      const bool shows_at_last = best.free < kHidden && here.free >= kHidden;
      if (here.free > best.free + kMuchBetter || shows_at_last || best.free < 0) {
        best = here;
      }
    }
  }
  return best;
}

/// Of many aims the one that is seen well, from a single side that is not hidden, the first such;
/// else the one that is seen best.
std::pair<Aimed, const Aim*> best_of(const ViewScene& scene, std::span<const Aim> aims,
                                     const Sides& sides, const FitCamera& fit, bool cut,
                                     const Limits& limits) {
  constexpr double kWell = 0.45;    // of its curve, whose rear the mover itself hides
  constexpr double kIndoors = 0.2;  // what a contact indoors counts
  const double enough = sides.all_around ? kWell : kHidden;
  std::pair<Aimed, const Aim*> best{{}, nullptr};
  best.first.free = -2;
  for (const Aim& aim : aims) {
    Aimed here = aimed(scene, aim, sides, fit, cut, limits);
    here.free *= cut ? 1 : kIndoors + (1 - kIndoors) * open_sky(aim, scene);
    if (here.free > best.first.free) {
      best = {here, &aim};
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
  std::vector<Vec3> places = places_of(touches, scene);
  const Box around = touching_box(body, touches, places, part_boxes);
  const Box whole = whole_box(scene, around, touches, part_boxes);
  return {.points = std::move(places), .around = around, .body = body, .whole = whole};
}

AimedCamera aimed_camera(const ViewScene& scene, std::span<const Aim> aims, const Sides& sides,
                         const FitCamera& fit, const Limits& limits) {
  auto [best, aim] = best_of(scene, aims, sides, fit, false, limits);
  if (sides.may_cut && sides.all_around && best.free < kHidden) {
    const auto cut = best_of(scene, aims, sides, fit, true, limits);
    if (cut.first.free > best.free) {
      std::tie(best, aim) = cut;
    }
  }
  return {best.camera, aim->around, aim->pair};
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
