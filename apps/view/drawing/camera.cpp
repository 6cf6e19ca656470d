#include "apps/view/drawing/camera.h"

#include "apps/view/drawing/length.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace soms::view {

namespace {

// The picture's upright direction turns over at the poles; the camera stops this far before them.
constexpr double kPoleMargin = 1e-3;
// Instead of no length at all.
constexpr double kLeastLength = std::numeric_limits<double>::min();

Vec3 scaled_to_one(const Vec3& v, const Vec3& otherwise) {
  const double size = length(v);
  return size > 0 && std::isfinite(size) ? v * (1 / size) : otherwise;
}

Vec3 upright(const Camera& camera) {
  return scaled_to_one(camera.up, {0, 0, 1});
}

// Turns a view direction about `up` and toward it, away from the poles.
Vec3 turned_direction(const CameraFrame& f, const Vec3& up, double yaw, double pitch) {
  const double rise = std::clamp(dot(f.forward, up), -1.0, 1.0);
  const Vec3 level = cross(up, f.right);
  const double limit = std::numbers::pi / 2 - kPoleMargin;
  const double elevation = std::clamp(std::asin(rise) + pitch, -limit, limit);
  const Vec3 ahead = level * std::cos(yaw) - f.right * std::sin(yaw);
  return ahead * std::cos(elevation) + up * std::sin(elevation);
}

Vec3 carried(const Pose& before, const Pose& after, const Vec3& p) {
  const Vec3 d = p - before.shift();
  const auto& m = before.m;
  const Vec3 inside{m[0] * d.x + m[4] * d.y + m[8] * d.z, m[1] * d.x + m[5] * d.y + m[9] * d.z,
                    m[2] * d.x + m[6] * d.y + m[10] * d.z};
  return after.apply(inside);
}

Vec3 corner(const Box& box, int i) {
  return {(i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
          (i & 4) != 0 ? box.upper.z : box.lower.z};
}

// Half the picture's height, at distance 1.
double slope(const Camera& camera) {
  return std::tan(camera.field_of_view / 2);
}

Vec3 mixed(const Vec3& a, const Vec3& b, double t) {
  return a * (1 - t) + b * t;
}

}  // namespace

CameraFrame frame(const Camera& camera) {
  const Vec3 up = upright(camera);
  const Vec3 level = look::frame_along(up, up).up * -1;  // for an eye on its target
  return look::frame_along(scaled_to_one(camera.target - camera.eye, level), up);
}

double distance_to_target(const Camera& camera) {
  return length(camera.target - camera.eye);
}

DepthRange depth_range(const Camera& camera, const Box& bounds) {
  const double reach = distance_to_target(camera);
  if (bounds.empty()) {
    const double scale = reach > 0 ? reach : 1;
    return {std::max(scale * 0.01, camera.cut), std::max(scale * 100, camera.cut * 2)};
  }
  const Vec3 forward = frame(camera).forward;
  double nearest = dot(corner(bounds, 0) - camera.eye, forward);
  double farthest = nearest;
  for (int i = 1; i < 8; ++i) {
    const double depth = dot(corner(bounds, i) - camera.eye, forward);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const double size = length(bounds.extent());
  const double least = std::max({reach * 5e-3, size * 1e-6, kLeastLength, camera.cut});
  const double near = std::max(nearest * 0.99, least);
  return {near, std::max(farthest * 1.01, near * 2)};
}

Camera orbited(const Camera& camera, double yaw, double pitch) {
  Camera result = camera;
  const double reach = distance_to_target(camera);
  const Vec3 forward = turned_direction(frame(camera), upright(camera), yaw, -pitch);
  result.eye = camera.target - forward * reach;
  return result;
}

Camera turned(const Camera& camera, double yaw, double pitch) {
  Camera result = camera;
  const double reach = distance_to_target(camera);
  const Vec3 forward = turned_direction(frame(camera), upright(camera), yaw, pitch);
  result.target = camera.eye + forward * reach;
  return result;
}

Camera panned(const Camera& camera, double right, double up) {
  const double height = 2 * slope(camera) * distance_to_target(camera);
  return flown(camera, right * height, 0, up * height);
}

Camera dollied(const Camera& camera, double factor) {
  Camera result = camera;
  result.eye = camera.target + (camera.eye - camera.target) * factor;
  if (camera.cut > 0) {
    result.cut = std::max(0.0, camera.cut + (factor - 1) * distance_to_target(camera));
  }
  return result;
}

Camera flown(const Camera& camera, double right, double forward, double up) {
  const CameraFrame f = frame(camera);
  const Vec3 shift = f.right * right + f.forward * forward + f.up * up;
  Camera result = camera;
  result.eye += shift;
  result.target += shift;
  return result;
}

Camera pivoted(const Camera& camera, const Vec3& pivot) {
  Camera result = camera;
  result.eye += pivot - camera.target;
  result.target = pivot;
  return result;
}

Camera followed(const Camera& camera, const Pose& before, const Pose& after) {
  Camera result = camera;
  result.eye = carried(before, after, camera.eye);
  result.target = carried(before, after, camera.target);
  return result;
}

Camera between(const Camera& a, const Camera& b, double t) {
  if (t <= 0) {
    return a;
  }
  if (t >= 1) {
    return b;
  }
  Camera result = b;
  result.target = mixed(a.target, b.target, t);
  result.field_of_view = a.field_of_view * (1 - t) + b.field_of_view * t;
  result.up = scaled_to_one(mixed(a.up, b.up, t), b.up);
  // Directions are mixed apart from distances, and distances by ratio, so that a flight from far to
  // near keeps an even speed. Opposite directions have no middle: then over the top.
  const Vec3 mix = mixed(frame(a).forward, frame(b).forward, t);
  const Vec3 forward = length(mix) > 1e-6 ? scaled_to_one(mix, mix) : upright(b) * -1;
  const double from = std::max(distance_to_target(a), kLeastLength);
  const double to = std::max(distance_to_target(b), kLeastLength);
  const double reach = std::pow(from, 1 - t) * std::pow(to, t);
  result.eye = result.target - forward * reach;
  if (b.cut > 0) {
    result.cut = std::max(0.0, b.cut + reach - to);
  }
  return result;
}

Camera fitted(const Box& box, const Vec3& toward_eye, Size size, double field_of_view) {
  Camera camera;
  camera.field_of_view = field_of_view;
  camera.target = box.empty() ? Vec3{} : box.center();
  const Vec3 back = scaled_to_one(toward_eye, {0, -1, 0});
  const CameraFrame f = look::frame_along(-back, camera.up);
  const double tall = slope(camera);
  const double wide = tall * size.width / std::max(size.height, 1);
  double reach = 0;
  for (int i = 0; i < 8 && !box.empty(); ++i) {
    const Vec3 d = corner(box, i) - camera.target;
    const double across = std::abs(dot(d, f.right)) / wide;
    const double along = std::abs(dot(d, f.up)) / tall;
    reach = std::max(reach, dot(d, back) + std::max(across, along));
  }
  constexpr double kMargin = 1.04;
  camera.eye = camera.target + back * (reach > 0 ? reach * kMargin : 1);
  return camera;
}

Camera framed(const Camera& camera, std::span<const Vec3> points, Size size) {
  if (points.empty()) {
    return camera;
  }
  // In the camera's directions about the first point: each side of the picture bounds where the eye
  // may be by a plane, and the eye is best where opposite planes meet.
  const CameraFrame f = frame(camera);
  constexpr double kMargin = 0.97;
  constexpr double kLeastClearance = 0.05;
  const double tall = slope(camera) * kMargin;
  const double wide = tall * size.width / std::max(size.height, 1);
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  double right = kNone, left = kNone, upper = kNone, lower = kNone, far = kNone, near = -kNone;
  for (const Vec3& point : points) {
    const Vec3 p = point - points[0];
    const double x = dot(p, f.right), y = dot(p, f.up), depth = dot(p, f.forward);
    right = std::max(right, x - wide * depth);
    left = std::max(left, -x - wide * depth);
    upper = std::max(upper, y - tall * depth);
    lower = std::max(lower, -y - tall * depth);
    far = std::max(far, depth);
    near = std::min(near, depth);
  }
  // A wide view could put the eye upon the nearest point.
  const double clear = kLeastClearance * (far - near) - near;
  const double back = std::max({(right + left) / (2 * wide), (upper + lower) / (2 * tall), clear});
  const double middle = (near + far) / 2;
  const double reach = middle + back > 0 ? middle + back : distance_to_target(camera);
  // Where a direction has room to spare, it is shared in the picture: half beside either edge.
  const auto centered = [&](const Vec3& direction, double low, double high) {
    for (int i = 0; i < 30; ++i) {
      const double at = (low + high) / 2;
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for (const Vec3& point : points) {
        const Vec3 p = point - points[0];
        const double seen = (dot(p, direction) - at) / (dot(p, f.forward) + back);
        least = std::min(least, seen);
        most = std::max(most, seen);
      }
      (least + most > 0 ? low : high) = at;
    }
    return (low + high) / 2;
  };
  Camera result = camera;
  result.target = points[0] + f.right * centered(f.right, right - wide * back, wide * back - left) +
                  f.up * centered(f.up, upper - tall * back, tall * back - lower) +
                  f.forward * middle;
  result.eye = result.target - f.forward * reach;
  return result;
}

Ray ray_through(const Camera& camera, Size size, PixelPoint pixel) {
  const CameraFrame f = frame(camera);
  const double unit = 2 * slope(camera) / size.height;
  const double x = (pixel.x - 0.5 * size.width) * unit;
  const double y = (0.5 * size.height - pixel.y) * unit;
  const Vec3 slant = f.forward + f.right * x + f.up * y;
  return {camera.eye + slant * camera.cut, scaled_to_one(slant, f.forward)};
}

std::optional<Projection> project(const Camera& camera, Size size, const Vec3& point) {
  const look::Eye eye{camera.eye, frame(camera), slope(camera)};
  const Vec3 seen = eye.see(point);
  if (!(seen.z > 0)) {
    return std::nullopt;
  }
  const Vec3 place = eye.place(seen, size.width, size.height);
  return Projection{{place.x, place.y}, seen.z};
}

double length_of_pixel(const Camera& camera, Size size, double depth) {
  return 2 * slope(camera) * depth / size.height;
}

}  // namespace soms::view
