/// \file
/// A camera in double precision: where it stands, what it sees, and how it moves.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/query/ray.h"

#include "apps/draw/eye.h"
#include "apps/draw/picture.h"

#include <functional>
#include <optional>
#include <span>

namespace soms::view {

using look::CameraFrame;
using look::PixelPoint;
using look::Size;

/// A perspective camera. It looks from `eye` to `target`, about which it orbits; `up` is the
/// world's direction that stays upright in the picture.
struct Camera {
  Vec3 eye{0, -10, 5};
  Vec3 target{0, 0, 0};
  Vec3 up{0, 0, 1};
  double field_of_view = 0.8;  ///< angle between the picture's lower and upper edge, radians
  /// Surfaces nearer than this, along the forward direction, are not drawn. Where the distance to
  /// the target changes, so does this: what is cut away stays so.
  double cut = 0;

  [[nodiscard]] bool operator==(const Camera&) const = default;
};

/// Distances along the forward direction between which things are drawn; `near` is no less than the
/// camera's `cut`.
struct DepthRange {
  double near = 0.1;
  double far = 1000;
};

/// A world point in a picture.
struct Projection {
  PixelPoint pixel;
  double depth = 0;  ///< distance along the forward direction, positive
};

/// Directions of a camera; well defined also where it looks along `up` or stands on its target.
[[nodiscard]] CameraFrame frame(const Camera& camera);

[[nodiscard]] double distance_to_target(const Camera& camera);

/// Range that holds all of `bounds` that the camera can see, with `near` as far off as the scene
/// allows, since precision in depth falls with far / near. From inside a scene `near` is a small
/// part of the distance to the target. An empty box gives a range about the target.
[[nodiscard]] DepthRange depth_range(const Camera& camera, const Box& bounds);

/// Turns the camera about its target: `yaw` radians counter-clockwise about `up` as seen from
/// above, `pitch` radians upward. It stops short of the poles, so that the picture never tips over.
[[nodiscard]] Camera orbited(const Camera& camera, double yaw, double pitch);

/// Turns the view about the eye: `yaw` radians to the left, `pitch` radians upward.
[[nodiscard]] Camera turned(const Camera& camera, double yaw, double pitch);

/// Shifts eye and target by `right` and `up` in units of the picture's height at the target, so a
/// drag of k pixels in a picture n pixels high is k / n.
[[nodiscard]] Camera panned(const Camera& camera, double right, double up);

/// Multiplies the distance to the target; below 1 goes nearer. \pre `factor` > 0.
[[nodiscard]] Camera dollied(const Camera& camera, double factor);

/// Moves eye and target together by lengths along the camera's directions.
[[nodiscard]] Camera flown(const Camera& camera, double right, double forward, double up);

/// Makes `pivot` the target without turning the view: the eye moves along.
[[nodiscard]] Camera pivoted(const Camera& camera, const Vec3& pivot);

/// The camera as it is after the body that it follows moved from `before` to `after`: same place
/// and view relative to the body, but kept upright.
[[nodiscard]] Camera followed(const Camera& camera, const Pose& before, const Pose& after);

/// The camera between two others; `t` = 0 gives `a`, 1 gives `b`.
[[nodiscard]] Camera between(const Camera& a, const Camera& b, double t);

/// A camera that sees all of `box` as large as fits, from the side that `toward_eye` points to.
/// An empty or point-like box is seen from distance 1.
[[nodiscard]] Camera fitted(const Box& box, const Vec3& toward_eye, Size size,
                            double field_of_view = 0.8);

/// The camera that sees all of a box from the side that a direction points to.
using FitCamera = std::function<Camera(const Box& box, const Vec3& toward_eye)>;

/// The camera moved without turning so that all `points` are seen as large as fits. The target
/// keeps their middle depth. Without points, or where they are one, only the place changes.
[[nodiscard]] Camera framed(const Camera& camera, std::span<const Vec3> points, Size size);

/// The ray of points that are seen at `pixel`: it begins where nothing is cut away. Its direction
/// has length 1.
[[nodiscard]] Ray ray_through(const Camera& camera, Size size, PixelPoint pixel);

/// Where a point is seen, inside the picture or beside it; nothing for points behind the eye.
[[nodiscard]] std::optional<Projection> project(const Camera& camera, Size size, const Vec3& point);

/// Length in the world that one pixel covers at a distance along the forward direction.
[[nodiscard]] double length_of_pixel(const Camera& camera, Size size, double depth);

}  // namespace soms::view
