#include "apps/view/drawing/sun_maps.h"

#include "apps/view/drawing/length.h"

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

/// Radius of the ball about the target, and most of the other, in distances to the target.
constexpr double kNearReach = 1.1;
constexpr double kFarReach = 9;
/// A scene up to this many times as large as the ball about the target takes that map alone.
constexpr double kAlone = 1.3;

Vec3 unit_of(const Vec3& v, const Vec3& otherwise) {
  const double size = length(v);
  return size > 0 ? v * (1 / size) : otherwise;
}

struct SunAxes {
  Vec3 right;
  Vec3 up;
  Vec3 toward;
};

SunAxes axes_of(const Light& light) {
  const Vec3 toward = unit_of(light.toward, {0, 0, 1});
  const Vec3 helper = std::abs(toward.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 right = unit_of(cross(helper, toward), {1, 0, 0});
  return {right, cross(toward, right), toward};
}

SunMap map_of(const Vec3& center, double radius, const GlView& view, const Light& light) {
  SunMap map{center, radius, {}, static_cast<float>(2 * radius * view.unit / kSunTexels)};
  const SunAxes axes = axes_of(light);
  const Vec3 middle = (center - view.eye) * view.unit;
  const double factor = 0.5 / (radius * view.unit);
  std::size_t row = 0;
  for (const Vec3& axis : {axes.right, axes.up, axes.toward}) {
    map.place[row] = static_cast<float>(axis.x * factor);
    map.place[row + 4] = static_cast<float>(axis.y * factor);
    map.place[row + 8] = static_cast<float>(axis.z * factor);
    map.place[row + 12] = static_cast<float>(0.5 - dot(axis, middle) * factor);
    ++row;
  }
  map.place[15] = 1;
  return map;
}

}  // namespace

std::array<SunMap, 2> sun_maps(const Camera& camera, const GlView& view, const Light& light,
                               const Box& scene) {
  const double reach = 1 / view.unit;
  const Vec3 extent = scene.empty() ? Vec3{1, 1, 1} * reach : scene.extent();
  const Vec3 center = scene.empty() ? camera.target : scene.center();
  const double whole = 0.505 * length(extent);
  if (whole <= kAlone * kNearReach * reach) {
    const SunMap all = map_of(center, whole, view, light);
    return {all, all};
  }
  const SunMap near = map_of(camera.target, kNearReach * reach, view, light);
  if (whole <= kFarReach * reach) {
    return {near, map_of(center, whole, view, light)};
  }
  const Vec3 ahead = camera.eye + frame(camera).forward * (0.8 * kFarReach * reach);
  return {near, map_of(ahead, kFarReach * reach, view, light)};
}

SunMap seen_by(const SunMap& map, const GlView& view, const Light& light) {
  return map_of(map.center, map.radius, view, light);
}

bool same_ball(const SunMap& a, const SunMap& b) {
  constexpr double kRounding = 1e-6;  // far below a texel
  const double slack = kRounding * a.radius;
  return length(a.center - b.center) <= slack && std::abs(a.radius - b.radius) <= slack;
}

bool casts_into(const SunMap& map, const Light& light, const Box& box) {
  if (box.empty()) {
    return false;
  }
  const SunAxes axes = axes_of(light);
  const Vec3 from = box.center() - map.center;
  const Vec3 half = box.extent() * 0.5;
  const auto reach = [&](const Vec3& n) {
    return std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
  };
  const double room = map.radius * (1 + 1e-9);
  return std::abs(dot(from, axes.right)) <= room + reach(axes.right) &&
         std::abs(dot(from, axes.up)) <= room + reach(axes.up) &&
         dot(from, axes.toward) >= -room - reach(axes.toward);
}

}  // namespace soms::view
