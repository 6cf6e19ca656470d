#include "apps/view/control/camera_moves.h"

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

constexpr double kTurnsAWindow = 2.5;    ///< radians for a drag over the window's height
constexpr double kLooksAWindow = 1.2;    ///< likewise when looking around
constexpr double kDollyAWindow = 3.0;    ///< natural logarithm of the factor, likewise
constexpr double kDollyANotch = 0.85;    ///< factor of one notch of the wheel
constexpr double kForwardANotch = 0.15;  ///< of the distance to the target
constexpr double kSceneASecond = 0.1;    ///< scenes flown through in a second
constexpr double kFast = 5;
constexpr double kNearestOfScene = 1e-9;
constexpr double kNearestOfPlace = 1e-12;  ///< of the target's coordinates
constexpr double kFarthestOfScene = 1e4;

/// The point of the plane through the target, square to the view, that is seen at a pixel.
Vec3 on_target_plane(const Camera& camera, Size size, PixelPoint pixel) {
  const Ray ray = ray_through(camera, size, pixel);
  const Vec3 forward = frame(camera).forward;
  const double slope = dot(ray.direction, forward);
  const double depth = dot(camera.target - camera.eye, forward);
  return ray.origin + ray.direction * (depth / slope);
}

/// Eye and target brought nearer to a point, which keeps its place in the picture.
Camera scaled_about(const Camera& camera, const Vec3& point, double factor) {
  Camera moved = dollied(camera, factor);
  const Vec3 target = point + (camera.target - point) * factor;
  moved.eye += target - camera.target;
  moved.target = target;
  return moved;
}

/// The factor of the distance to the target as far as the ends allow it.
double bounded(double factor, const Camera& camera, const ZoomEnds& ends) {
  const double distance = distance_to_target(camera);
  if (!(distance > 0)) {
    return 1;
  }
  return std::clamp(factor, std::min(ends.nearest / distance, 1.0),
                    std::max(ends.farthest / distance, 1.0));
}

Vec3 toward_eye(Side side) {
  switch (side) {
    case Side::front:
      return {0, -1, 0};
    case Side::right:
      return {1, 0, 0};
    case Side::top:
      return {0, -1e-3, 1};
    case Side::corner:
      return {0.6, -0.9, 0.7};
  }
  return {0, -1, 0};
}

}  // namespace

ZoomEnds zoom_ends(double scene_size, const Vec3& target) {
  const double size = scene_size > 0 ? scene_size : 1;
  const double place = std::max({std::abs(target.x), std::abs(target.y), std::abs(target.z)});
  return {std::max(kNearestOfScene * size, kNearestOfPlace * place), kFarthestOfScene * size};
}

Camera dragged(const Camera& camera, CameraMode mode, CameraDrag drag, double dx, double dy,
               Size size, const ZoomEnds& ends) {
  const double height = std::max(size.height, 1);
  const double right = dx / height;
  const double down = dy / height;
  switch (drag) {
    case CameraDrag::turn:
      return mode == CameraMode::fly
                 ? turned(camera, -kLooksAWindow * right, -kLooksAWindow * down)
                 : orbited(camera, -kTurnsAWindow * right, kTurnsAWindow * down);
    case CameraDrag::pan:
      return panned(camera, -right, down);
    case CameraDrag::dolly:
      return dollied(camera, bounded(std::exp(kDollyAWindow * down), camera, ends));
  }
  return camera;
}

Camera wheeled(const Camera& camera, CameraMode mode, double notches, PixelPoint pixel, Size size,
               std::optional<Vec3> under, const ZoomEnds& ends) {
  if (mode == CameraMode::fly) {
    return flown(camera, 0, notches * kForwardANotch * distance_to_target(camera), 0);
  }
  const double factor = bounded(std::pow(kDollyANotch, notches), camera, ends);
  return scaled_about(camera, under.value_or(on_target_plane(camera, size, pixel)), factor);
}

Camera flown(const Camera& camera, const FlyKeys& keys, double seconds, double scene_size) {
  const double step = seconds * scene_size * kSceneASecond * (keys.fast ? kFast : 1);
  const double right = (keys.right ? step : 0) - (keys.left ? step : 0);
  const double forward = (keys.forward ? step : 0) - (keys.backward ? step : 0);
  return flown(camera, right, forward, 0);
}

Camera fitted_beside(const Box& box, const Vec3& toward_eye, Size size, const Covered& covered,
                     double field_of_view) {
  const int free =
      std::max(static_cast<int>(size.width - covered.left - covered.right), size.width / 4);
  const Camera whole = fitted(box, toward_eye, {free, size.height}, field_of_view);
  return panned(whole, -0.5 * (covered.left - covered.right) / std::max(size.height, 1), 0);
}

Camera seen_from(const Box& box, Side side, Size size, double field_of_view,
                 const Covered& covered) {
  return fitted_beside(box, toward_eye(side), size, covered, field_of_view);
}

Camera CameraFlight::after(double seconds) {
  elapsed_ = std::min(elapsed_ + seconds, kSeconds);
  if (over()) {
    return to_;
  }
  const double t = elapsed_ / kSeconds;
  return between(from_, to_, t * t * (3 - 2 * t));
}

}  // namespace soms::view
