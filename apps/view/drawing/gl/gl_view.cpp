#include "apps/view/drawing/gl/gl_view.h"

#include "apps/view/drawing/length.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

// Rotates device coordinates to x right, y up, z forward.
glm::dmat4 turned_to(const CameraFrame& f) {
  return glm::transpose(glm::dmat4{{f.right.x, f.right.y, f.right.z, 0},
                                   {f.up.x, f.up.y, f.up.z, 0},
                                   {f.forward.x, f.forward.y, f.forward.z, 0},
                                   {0, 0, 0, 1}});
}

// Clip w is the distance forward. Reversed: depth is near / w, and there is no far end.
glm::dmat4 projected(const Camera& camera, Size size, double near, double far, DepthMode mode) {
  const double tall = 1 / std::tan(camera.field_of_view / 2);
  const double wide = tall * size.height / size.width;
  glm::dmat4 m(0.0);
  m[0][0] = wide;
  m[1][1] = tall;
  m[2][3] = 1;
  if (mode == DepthMode::reversed) {
    m[3][2] = near;
  } else {
    m[2][2] = (far + near) / (far - near);
    m[3][2] = -2 * far * near / (far - near);
  }
  return m;
}

}  // namespace

std::array<float, 3> narrow(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

std::array<float, 4> parts_of(Color c) {
  return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255,
          static_cast<float>(c.b) / 255, 1};
}

std::array<float, 3> GlView::relative(const Vec3& p) const {
  return narrow((p - eye) * unit);
}

GlView gl_view(const Camera& camera, Size size, const Light& light, const DepthRange& range,
               DepthMode mode) {
  GlView view;
  view.eye = camera.eye;
  const double reach = distance_to_target(camera);
  view.unit = 1 / (reach > 0 ? reach : range.far);
  const glm::dmat4 clip =
      projected(camera, size, range.near * view.unit, range.far * view.unit, mode) *
      turned_to(frame(camera));
  const glm::mat4 short_clip(clip);
  std::copy_n(glm::value_ptr(short_clip), 16, view.clip.begin());
  view.nearest = static_cast<float>(range.near * view.unit);
  view.half_width = 0.5F * static_cast<float>(size.width);
  view.half_height = 0.5F * static_cast<float>(size.height);
  view.slope = static_cast<float>(length_of_pixel(camera, size, 1));
  view.lift = mode == DepthMode::reversed ? 1 - 2e-4F : 1 - 2e-3F;
  const double far_off = length(light.toward);
  const Vec3 toward = far_off > 0 ? light.toward * (1 / far_off) : Vec3{0, 0, 1};
  view.toward = narrow(toward);
  const double rise = length(camera.up);
  view.above = narrow(rise > 0 ? camera.up * (1 / rise) : Vec3{0, 0, 1});
  const CameraFrame axes = frame(camera);
  view.right = narrow(axes.right);
  view.upward = narrow(axes.up);
  view.forward = narrow(axes.forward);
  const double tall = std::tan(camera.field_of_view / 2);
  view.slopes = {static_cast<float>(tall * size.width / size.height), static_cast<float>(tall)};
  const double near = range.near * view.unit;
  const double far = range.far * view.unit;
  // Plain depths d have 2 d - 1 = (far + near) / (far - near) - 2 far near / ((far - near) w).
  view.inverse_depth = mode == DepthMode::reversed
                           ? std::array<float, 2>{static_cast<float>(1 / near), 0}
                           : std::array<float, 2>{static_cast<float>(1 / far - 1 / near),
                                                  static_cast<float>(1 / near)};
  view.ambient = std::clamp(light.ambient, 0.0F, 1.0F);
  return view;
}

std::array<float, 12> relative_rows(const GlView& view, const Pose& pose, const Vec3& origin,
                                    double scale) {
  const std::array<float, 3> t = view.relative(pose.apply(origin));
  const double s = scale * view.unit;
  std::array<float, 12> rows{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      rows[4 * r + c] = static_cast<float>(pose.m[4 * r + c] * s);
    }
    rows[4 * r + 3] = t[r];
  }
  return rows;
}

}  // namespace soms::view
