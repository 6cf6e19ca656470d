#include "apps/view/verbs/aimed_camera.h"

#include "soms/base/common_box.h"
#include "soms/base/error.h"

#include "apps/view/scene/part_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// What is seen less than this of a contact is looked at with what is before it cut away.
constexpr double kHidden = 0.15;

/// What a camera looks at: what must not be hidden, and what shall be in the picture.
struct Aim {
  std::vector<Vec3> points;
  Box around;
  BodyRef body;
  bool is_middle = false;  ///< the one point is the body's own middle
};

Aim aim_at_mover(std::uint32_t number, bool with_gap, const ViewScene& scene) {
  if (number >= scene.movers()) {
    throw Error(ErrorKind::usage,
                fmt::format("--camera mover:{}: the scene has {} movers", number, scene.movers()),
                "movers are numbered from 0; --count sets how many there are");
  }
  const BodyRef body = mover(number);
  Aim aim{{scene.bounds(body).center()}, scene.bounds(body), body, true};
  if (!with_gap) {
    return aim;
  }
  if (const auto& gap = scene.gap(); gap && (gap->a == body || gap->b == body)) {
    aim.around.grow(gap->distance.point_a);
    aim.around.grow(gap->distance.point_b);
  }
  return aim;
}

/// Places on the curves of contacts, evenly over their list.
std::vector<Vec3> places_of(const std::vector<Touch>& touches, const ViewScene& scene) {
  constexpr std::size_t kMost = 24;
  std::vector<Vec3> places;
  const std::size_t count = std::min(touches.size(), kMost);
  for (std::size_t k = 0; k < count; ++k) {
    const Crossing crossing = scene.crossing(touches[k * touches.size() / count]);
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

/// Movers that touch anything, those with most contacts first.
std::vector<Aim> aims_at_contacts(const ViewScene& scene) {
  constexpr std::size_t kMost = 40;
  std::map<BodyRef, std::vector<Touch>> touching;
  for (const Touch& touch : scene.contacts()) {
    touching[touch.a].push_back(touch);
    if (touch.b.role == Role::mover) {
      touching[touch.b].push_back(touch);
    }
  }
  if (touching.empty()) {
    throw Error(ErrorKind::usage, "--camera contact: nothing touches in this frame",
                "choose another --frame, or leave out contact");
  }
  std::vector<std::pair<std::size_t, BodyRef>> order;
  order.reserve(touching.size());
  for (const auto& [body, touches] : touching) {
    order.emplace_back(touches.size(), body);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Aim> aims;
  PartBoxes part_boxes(scene);
  for (std::size_t i = 0; i < std::min(order.size(), kMost); ++i) {
    const BodyRef body = order[i].second;
    aims.push_back(
        {places_of(touching[body], scene), touching_box(body, touching[body], part_boxes), body});
  }
  return aims;
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
  const double thin = kThin * line_length(aim.around.extent());
  std::size_t seen = 0;
  for (std::size_t k = 0; k < aim.points.size(); ++k) {
    const double whole = line_length(rays[k].direction);
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
  const Vec3 above{center.x, center.y, aim.around.upper.z + 0.1 * line_length(aim.around.extent())};
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
Aimed aimed(const CameraChoice& choice, const Aim& aim, const ViewScene& scene, Size size, bool cut,
            const Parallel& parallel) {
  constexpr double kAimSurroundings = 1.5;  // half of the picture's box, in extents of the subject
  constexpr double kMuchBetter = 0.2;
  const Vec3 half = aim.around.extent() * kAimSurroundings;
  const Vec3 center = aim.around.center();
  const Box wide = common_box({center - half, center + half}, scene_bounds(scene));
  const auto from = [&](double bearing, double elevation) {
    Camera camera = dollied(fitted(wide, toward_eye(bearing, elevation), size), 1 / choice.zoom);
    camera.cut = cut ? std::max(0.0, front_of(aim.around, camera)) : 0.0;
    return camera;
  };
  Aimed best{from(choice.bearing, choice.elevation), choice.free_side ? -1.0 : 1.0};
  for (const double elevation : {25.0, 45.0, 65.0}) {
    for (int turn = 0; choice.free_side && turn < 16; ++turn) {
      check_stop(parallel);
      const Camera camera = from(choice.bearing + 22.5 * turn, elevation);
      const double free = seen_share(aim, camera, scene);
      if (free > best.free + kMuchBetter || (best.free < 0 && free >= 0)) {
        best = {camera, free};
      }
    }
  }
  return best;
}

/// Of many aims the one that is seen well, the first such; else the one that is seen best.
Aimed best_of(const CameraChoice& choice, const std::vector<Aim>& aims, const ViewScene& scene,
              Size size, bool cut, const Parallel& parallel) {
  constexpr double kEnough = 0.45;  // of its curve, whose rear the mover itself hides
  constexpr double kIndoors = 0.2;  // what a contact indoors counts
  Aimed best;
  best.free = -2;
  for (const Aim& aim : aims) {
    Aimed here = aimed(choice, aim, scene, size, cut, parallel);
    here.free *= cut ? 1 : kIndoors + (1 - kIndoors) * open_sky(aim, scene);
    if (here.free > best.free) {
      best = here;
    }
    if (best.free >= kEnough) {
      break;
    }
  }
  return best;
}

/// As `best_of`; where next to nothing is seen, what is before it is cut away if that may be.
Camera seen_or_cut(const CameraChoice& choice, const std::vector<Aim>& aims, const ViewScene& scene,
                   Size size, const Parallel& parallel) {
  const Aimed whole = best_of(choice, aims, scene, size, false, parallel);
  if (!choice.may_cut || !choice.free_side || whole.free >= kHidden) {
    return whole.camera;
  }
  const Aimed cut = best_of(choice, aims, scene, size, true, parallel);
  return cut.free > whole.free ? cut.camera : whole.camera;
}

}  // namespace

Vec3 toward_eye(double bearing, double elevation) {
  const double level = std::cos(elevation * kDegree);
  return {level * std::sin(bearing * kDegree), level * std::cos(bearing * kDegree),
          std::sin(elevation * kDegree)};
}

double line_length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

Camera at_mover(const CameraChoice& choice, const ViewScene& scene, Size size,
                const Parallel& parallel) {
  return seen_or_cut(choice, {aim_at_mover(choice.mover, choice.with_gap, scene)}, scene, size,
                     parallel);
}

Camera at_contact(const CameraChoice& choice, const ViewScene& scene, Size size,
                  const Parallel& parallel) {
  return seen_or_cut(choice, aims_at_contacts(scene), scene, size, parallel);
}

}  // namespace soms::view
