#include "apps/view/control/gizmo.h"

#include "apps/view/drawing/length.h"
#include "apps/view/drawing/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace soms::view {

namespace {

constexpr std::array<Vec3, 3> kAxisDirections{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<Color, 3> kColors{palette::kOrange, palette::kGreen, palette::kBlue};
constexpr double kSquareFrom = 0.28;  ///< of the arrow's length
constexpr double kSquareTo = 0.52;
constexpr double kRing = 0.85;
constexpr double kHeadLength = 0.16;
constexpr double kHeadWidth = 0.06;
constexpr std::size_t kRingParts = 48;
/// Least sine of the angle to the view at which a drag still makes sense: about 3 degrees.
constexpr double kLeastSine = 0.05;

bool is_axis(Handle handle) {
  return handle <= Handle::axis_z;
}

/// Axis of an arrow, normal of a square, axis of the ring.
const Vec3& direction(Handle handle) {
  if (handle == Handle::turn) {
    return kAxisDirections[2];
  }
  return kAxisDirections[static_cast<std::size_t>(handle) % 3];
}

Vec3 ring_point(const Gizmo& gizmo, std::size_t i) {
  const double angle =
      2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kRingParts);
  const double radius = kRing * gizmo.size;
  return gizmo.center + Vec3{radius * std::cos(angle), radius * std::sin(angle), 0};
}

/// Corners of a plane handle in order round it.
std::array<Vec3, 4> square(const Gizmo& gizmo, Handle handle) {
  const std::size_t normal = static_cast<std::size_t>(handle) % 3;
  const Vec3 u = kAxisDirections[(normal + 1) % 3] * gizmo.size;
  const Vec3 v = kAxisDirections[(normal + 2) % 3] * gizmo.size;
  const Vec3& c = gizmo.center;
  return {c + u * kSquareFrom + v * kSquareFrom, c + u * kSquareTo + v * kSquareFrom,
          c + u * kSquareTo + v * kSquareTo, c + u * kSquareFrom + v * kSquareTo};
}

/// Distance in pixels from a pixel to the projection of a segment; infinite if it is not seen.
double pixels_to_segment(const Camera& camera, Size size, PixelPoint at, const Vec3& a,
                         const Vec3& b) {
  const auto from = project(camera, size, a);
  const auto to = project(camera, size, b);
  if (!from || !to) {
    return std::numeric_limits<double>::infinity();
  }
  const double dx = to->pixel.x - from->pixel.x;
  const double dy = to->pixel.y - from->pixel.y;
  const double px = at.x - from->pixel.x;
  const double py = at.y - from->pixel.y;
  const double squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(px - t * dx, py - t * dy);
}

double pixels_to_ring(const Gizmo& gizmo, const Camera& camera, Size size, PixelPoint at) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kRingParts; ++i) {
    least = std::min(
        least, pixels_to_segment(camera, size, at, ring_point(gizmo, i), ring_point(gizmo, i + 1)));
  }
  return least;
}

bool in_square(const Gizmo& gizmo, Handle handle, const Ray& ray) {
  const auto point = meet_plane(ray, gizmo.center, direction(handle));
  if (!point) {
    return false;
  }
  const std::size_t normal = static_cast<std::size_t>(handle) % 3;
  const Vec3 offset = *point - gizmo.center;
  const auto within = [&](std::size_t axis) {
    return offset[axis] >= kSquareFrom * gizmo.size && offset[axis] <= kSquareTo * gizmo.size;
  };
  return within((normal + 1) % 3) && within((normal + 2) % 3);
}

/// An arrow can be dragged unless it points to the eye or away from it.
bool axis_is_usable(const Gizmo& gizmo, const Camera& camera, const Vec3& axis) {
  const Vec3 view = gizmo.center - camera.eye;
  const double far = length(view);
  return far > 0 && length(cross(view, axis)) > 3 * kLeastSine * far;
}

}  // namespace

std::optional<Gizmo> gizmo_at(const Camera& camera, Size size, const Vec3& center, double pixels) {
  const auto seen = project(camera, size, center);
  if (!seen) {
    return std::nullopt;
  }
  return Gizmo{center, pixels * length_of_pixel(camera, size, seen->depth)};
}

std::optional<Handle> handle_at(const Gizmo& gizmo, const Camera& camera, Size size,
                                PixelPoint pixel, double slack) {
  std::optional<Handle> nearest;
  double least = slack;
  for (const Handle handle : {Handle::axis_x, Handle::axis_y, Handle::axis_z}) {
    const Vec3& axis = direction(handle);
    // The first tenth belongs to no arrow: there all three meet.
    const double apart =
        pixels_to_segment(camera, size, pixel, gizmo.center + axis * (0.1 * gizmo.size),
                          gizmo.center + axis * gizmo.size);
    if (apart <= least && axis_is_usable(gizmo, camera, axis)) {
      least = apart;
      nearest = handle;
    }
  }
  if (nearest) {
    return nearest;
  }
  const Ray ray = ray_through(camera, size, pixel);
  for (const Handle handle : {Handle::plane_xy, Handle::plane_yz, Handle::plane_zx}) {
    if (in_square(gizmo, handle, ray)) {
      return handle;
    }
  }
  const bool ring = pixels_to_ring(gizmo, camera, size, pixel) <= slack &&
                    meet_plane(ray, gizmo.center, kAxisDirections[2]).has_value();
  return ring ? std::optional(Handle::turn) : std::nullopt;
}

void draw(const Gizmo& gizmo, std::optional<Handle> chosen, DrawList& list) {
  const auto color = [&](Handle handle, Color plain) {
    return chosen == handle ? palette::kYellow : plain;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const auto handle = static_cast<Handle>(i);
    const Color ink = color(handle, kColors[i]);
    const Vec3 tip = gizmo.center + kAxisDirections[i] * gizmo.size;
    list.lines.push_back({gizmo.center, tip, ink, 3, true});
    const Vec3 neck = gizmo.center + kAxisDirections[i] * (gizmo.size * (1 - kHeadLength));
    for (const std::size_t other : {(i + 1) % 3, (i + 2) % 3}) {
      const Vec3 side = kAxisDirections[other] * (gizmo.size * kHeadWidth);
      list.marks.push_back({{neck - side, neck + side, tip}, ink, true});
    }
    const auto plane = static_cast<Handle>(i + 3);
    const auto q = square(gizmo, plane);
    const Color fill = with_alpha(color(plane, kColors[i]), 150);
    list.marks.push_back({{q[0], q[1], q[2]}, fill, true});
    list.marks.push_back({{q[0], q[2], q[3]}, fill, true});
  }
  for (std::size_t i = 0; i < kRingParts; ++i) {
    list.lines.push_back({ring_point(gizmo, i), ring_point(gizmo, i + 1),
                          color(Handle::turn, palette::kSkyBlue), 2, true});
  }
}

std::array<Vec3, 3> tips(const Gizmo& gizmo) {
  const double reach = 1.1 * gizmo.size;
  return {gizmo.center + kAxisDirections[0] * reach, gizmo.center + kAxisDirections[1] * reach,
          gizmo.center + kAxisDirections[2] * reach};
}

GizmoDrag::GizmoDrag(const Gizmo& gizmo, Handle handle, const Pose& object, const Ray& ray)
    : gizmo_(gizmo), handle_(handle), start_(object), last_(object) {
  const auto point = is_axis(handle) ? nearest_on_axis(ray, gizmo.center, direction(handle))
                                     : meet_plane(ray, gizmo.center, direction(handle));
  grabbed_ = point.value_or(gizmo.center);
}

Pose GizmoDrag::dragged(const Ray& ray) {
  const auto point = is_axis(handle_) ? nearest_on_axis(ray, gizmo_.center, direction(handle_))
                                      : meet_plane(ray, gizmo_.center, direction(handle_));
  if (!point) {
    return last_;
  }
  if (handle_ != Handle::turn) {
    last_ = shifted(start_, *point - grabbed_);
    return last_;
  }
  const Vec3 from = grabbed_ - gizmo_.center;
  const Vec3 to = *point - gizmo_.center;
  const double angle = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
  last_ = turned_about(start_, gizmo_.center, angle);
  return last_;
}

std::optional<Vec3> nearest_on_axis(const Ray& ray, const Vec3& origin, const Vec3& axis) {
  const Vec3 apart = origin - ray.origin;
  const double along = dot(axis, ray.direction);
  const double sine_squared = 1 - along * along;
  if (sine_squared < kLeastSine * kLeastSine) {
    return std::nullopt;
  }
  // Both lines at their nearest: the connection is square to either.
  const double on_axis = (along * dot(ray.direction, apart) - dot(axis, apart)) / sine_squared;
  const Vec3 point = origin + axis * on_axis;
  if (dot(point - ray.origin, ray.direction) <= 0) {
    return std::nullopt;
  }
  return point;
}

std::optional<Vec3> meet_plane(const Ray& ray, const Vec3& origin, const Vec3& normal) {
  const double down = dot(ray.direction, normal);
  if (std::abs(down) < kLeastSine) {
    return std::nullopt;
  }
  const double t = dot(origin - ray.origin, normal) / down;
  if (t <= 0) {
    return std::nullopt;
  }
  return ray.origin + ray.direction * t;
}

Pose turned_about(const Pose& pose, const Vec3& center, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  std::array<Vec3, 3> columns;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3 v{pose.m[j], pose.m[4 + j], pose.m[8 + j]};
    columns[j] = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
  }
  // Gram and Schmidt, so that the rounding of many turns does not add up.
  columns[0] = columns[0] * (1 / length(columns[0]));
  columns[1] = columns[1] - columns[0] * dot(columns[0], columns[1]);
  columns[1] = columns[1] * (1 / length(columns[1]));
  columns[2] = cross(columns[0], columns[1]);
  const Vec3 arm = pose.shift() - center;
  const Vec3 shift = center + Vec3{c * arm.x - s * arm.y, s * arm.x + c * arm.y, arm.z};
  Pose turned;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      turned.m[4 * i + j] = columns[j][i];
    }
    turned.m[4 * i + 3] = shift[i];
  }
  return turned;
}

Pose shifted(const Pose& pose, const Vec3& offset) {
  Pose moved = pose;
  moved.m[3] += offset.x;
  moved.m[7] += offset.y;
  moved.m[11] += offset.z;
  return moved;
}

}  // namespace soms::view
