/// \file
/// From where pictures are seen, and the light in which their surfaces are.
#pragma once

#include "soms/base/vector.h"

namespace soms::look {

/// A camera's directions, each of length 1 and square to the others.
struct CameraFrame {
  Vec3 right;
  Vec3 up;
  Vec3 forward;

  /// How far a vector leads to the right, downward and forward: a parallel projection, with depths.
  [[nodiscard]] Vec3 on_page(const Vec3& v) const {
    return {dot(v, right), -dot(v, up), dot(v, forward)};
  }
};

/// The frame of a look along a direction; well defined also where that is along `up`.
/// \pre Both have length 1.
[[nodiscard]] CameraFrame frame_along(const Vec3& forward, const Vec3& up);

/// An eye that sees in perspective.
struct Eye {
  Vec3 at = {};
  CameraFrame frame = {};
  double tangent = 1;  ///< of half the angle at which a picture's height is seen

  /// A point from the eye: to the right, downward and forward.
  [[nodiscard]] Vec3 see(const Vec3& point) const { return frame.on_page(point - at); }

  /// Where a picture of so many pixels shows what `see` gave. The third coordinate is less the
  /// nearer the point is; on a flat surface it is linear in the other two. \pre seen.z > 0.
  [[nodiscard]] Vec3 place(const Vec3& seen, double width, double height) const;
};

/// How bright a flat surface is, from `ambient` to 1, in the light of a sun behind the eye, up on
/// the left. The side that the eye sees is lit, whichever way `normal` points; without length it
/// counts as facing the sun. \pre `sight` leads from the eye to the surface.
[[nodiscard]] double brightness(const CameraFrame& frame, const Vec3& normal, const Vec3& sight,
                                double ambient);

}  // namespace soms::look
