#include "apps/view/verbs/aimed_camera.h"

#include "soms/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

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
    aims.push_back(aim_at_touches(scene, body, touching[body], part_boxes));
  }
  return aims;
}

/// The camera on one of the aims, as chosen.
AimedCamera on_one_of(const std::vector<Aim>& aims, const CameraChoice& choice,
                      const ViewScene& scene, Size size, const Limits& limits) {
  const FitCamera fit = [&](const Box& box, const Vec3& toward) {
    return dollied(fitted(box, toward, size), 1 / choice.zoom);
  };
  return aimed_camera(scene, aims,
                      {choice.bearing, choice.elevation, choice.free_side, choice.may_cut}, fit,
                      limits);
}

}  // namespace

AimedCamera at_mover(const CameraChoice& choice, const ViewScene& scene, Size size,
                     const Limits& limits) {
  return on_one_of({aim_at_mover(choice.mover, choice.with_gap, scene)}, choice, scene, size,
                   limits);
}

AimedCamera at_contact(const CameraChoice& choice, const ViewScene& scene, Size size,
                       const Limits& limits) {
  return on_one_of(aims_at_contacts(scene), choice, scene, size, limits);
}

}  // namespace soms::view
