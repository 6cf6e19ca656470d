#include "apps/report/sight.h"

#include "apps/report/placing.h"

#include <algorithm>

namespace soms::report {

namespace {

/// So many times the length of a crossing, or of a gap, is worth seeing around it; a crossing that
/// is a point counts as this share of the smaller triangle, a small gap as one of the smaller body.
constexpr double kAround = 6;
constexpr double kLeastOfTriangle = 0.1;
constexpr double kLeastOfBody = 0.5;
/// Of the whole scene no more than this share: a contact is something to fly to.
constexpr double kShareOfScene = 0.1;

double half_size(const Scene& scene, std::span<const Box> bounds, std::uint32_t body) {
  return 0.5 * length(bounds[scene.bodies[body].model].extent());
}

}  // namespace

Sight sight_of(const SceneContact& contact, const Scene& scene, std::span<const Box> bounds,
               double size) {
  const auto [pose_a, pose_b] = poses_of(scene, contact);
  const double smaller_body =
      std::min(half_size(scene, bounds, contact.a), half_size(scene, bounds, contact.b));
  // Of a passage the whole mover is worth seeing: who passes is what it tells.
  Sight sight{.focus = pose_a.apply(bounds[scene.bodies[contact.a].model].center()),
              .reach = contact.poses ? smaller_body : std::min(smaller_body, kShareOfScene * size)};
  if (contact.pairs.empty()) {
    return sight;
  }
  const auto triangle = [&](std::uint32_t body, TriangleId i, const Pose& pose) {
    return moved(scene.models[scene.bodies[body].model].mesh.triangle(i), pose);
  };
  const auto& [i, j] = contact.pairs.front();
  const Triangle a = triangle(contact.a, i, pose_a);
  const Triangle b = triangle(contact.b, j, pose_b);
  const auto [from, to] = crossing_line(a, b);
  sight.focus = (from + to) * 0.5;
  const double smaller =
      std::min(length(soms::bounds(a).extent()), length(soms::bounds(b).extent()));
  const double crossing = std::max(length(to - from), kLeastOfTriangle * smaller);
  if (crossing > 0 && !contact.poses) {
    sight.reach = std::min(sight.reach, kAround * crossing);
  }
  return sight;
}

Sight sight_of(const SceneRow& row, const Scene& scene, std::span<const Box> bounds, double size) {
  const double smaller = std::min(half_size(scene, bounds, row.a), half_size(scene, bounds, row.b));
  const double around = std::max(0.5 * length(row.box.extent()), kLeastOfBody * smaller);
  return {.focus = row.place, .reach = std::min(around, kShareOfScene * size)};
}

Sight sight_of(const SceneGap& gap, const Scene& scene, std::span<const Box> bounds, double size) {
  const double segment = length(gap.point_b - gap.point_a);
  const double smaller = std::min(half_size(scene, bounds, gap.a), half_size(scene, bounds, gap.b));
  const double around = std::min(
      {smaller, kShareOfScene * size, std::max(kAround * segment, kLeastOfBody * smaller)});
  return {.focus = (gap.point_a + gap.point_b) * 0.5, .reach = std::max(around, segment)};
}

}  // namespace soms::report
