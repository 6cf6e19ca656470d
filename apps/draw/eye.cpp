#include "apps/draw/eye.h"

#include <algorithm>
#include <cmath>

namespace soms::look {

namespace {

double length_of(const Vec3& v) {
  return std::hypot(v.x, v.y, v.z);
}

/// A direction square to a unit vector: +x for +z, so a plan shows x to the right.
Vec3 square_to(const Vec3& unit) {
  const Vec3 axis = std::abs(unit.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 square = axis - unit * dot(axis, unit);
  return square * (1 / length_of(square));
}

}  // namespace

CameraFrame frame_along(const Vec3& forward, const Vec3& up) {
  Vec3 right = cross(forward, up);
  const double size = length_of(right);
  right = size > 1e-9 ? right * (1 / size) : square_to(up);
  return {right, cross(right, forward), forward};
}

Vec3 Eye::place(const Vec3& seen, double width, double height) const {
  const double pixels = 0.5 * height / (tangent * seen.z);  // a unit
  return {0.5 * width + seen.x * pixels, 0.5 * height + seen.y * pixels, -1 / seen.z};
}

double brightness(const CameraFrame& frame, const Vec3& normal, const Vec3& sight, double ambient) {
  const double size = length_of(normal);
  if (!(size > 0)) {
    return 1;
  }
  const Vec3 sun = frame.up * 0.66 - frame.right * 0.45 - frame.forward * 0.6;  // length 1
  const double facing = dot(normal, sight) > 0 ? -1 : 1;
  return ambient + (1 - ambient) * std::clamp(facing * dot(normal, sun) / size, 0.0, 1.0);
}

}  // namespace soms::look
