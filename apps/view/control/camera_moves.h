/// \file
/// What drags, wheel turns and flying keys do to the camera in each mode.
#pragma once

#include "soms/base/box.h"

#include "apps/view/control/view_state.h"
#include "apps/view/drawing/camera.h"

#include <optional>

namespace soms::view {

/// What a drag of the mouse does to the camera.
enum class CameraDrag { turn, pan, dolly };

/// How near to its target and how far from it a camera may be brought. One that is beyond an end
/// may come back.
struct ZoomEnds {
  double nearest = 0x1p-500;
  double farthest = 0x1p500;
};

/// Ends in a scene whose greatest side is so long: near enough for the smallest triangle, but where
/// doubles at the target still tell the direction of view.
[[nodiscard]] ZoomEnds zoom_ends(double scene_size, const Vec3& target);

/// The camera after the mouse moved by `dx`, `dy` pixels (down is positive) with a button held.
/// Orbiting and following, `turn` goes about the target; flying, it looks around.
[[nodiscard]] Camera dragged(const Camera& camera, CameraMode mode, CameraDrag drag, double dx,
                             double dy, Size size, const ZoomEnds& ends = {});

/// The camera after `notches` of the wheel away from the user, with the cursor at `pixel`: what
/// lies under the cursor stays there. `under` is the point that is seen there; without one the
/// plane through the target takes its place. Flying, the camera goes forward instead.
[[nodiscard]] Camera wheeled(const Camera& camera, CameraMode mode, double notches,
                             PixelPoint pixel, Size size, std::optional<Vec3> under,
                             const ZoomEnds& ends = {});

/// Keys that fly, while they are held.
struct FlyKeys {
  bool forward = false;
  bool backward = false;
  bool left = false;
  bool right = false;
  bool fast = false;

  [[nodiscard]] bool any() const { return forward || backward || left || right; }
};

/// The camera after flying for some seconds through a scene of this size; fast is five times that.
[[nodiscard]] Camera flown(const Camera& camera, const FlyKeys& keys, double seconds,
                           double scene_size);

/// Pixels of a picture that panels cover.
struct Covered {
  double left = 0;
  double right = 0;

  [[nodiscard]] bool operator==(const Covered&) const = default;
};

/// As `fitted`, in the part of a picture that is not covered, a quarter at least.
[[nodiscard]] Camera fitted_beside(const Box& box, const Vec3& toward_eye, Size size,
                                   const Covered& covered, double field_of_view);

/// The camera that sees all of `box` from a side.
[[nodiscard]] Camera seen_from(const Box& box, Side side, Size size, double field_of_view,
                               const Covered& covered = {});

/// A short glide from one camera to another, so that the eye can follow.
class CameraFlight {
 public:
  CameraFlight(const Camera& from, const Camera& to) : from_(from), to_(to) {}

  /// The camera `seconds` later; at the end exactly the goal.
  [[nodiscard]] Camera after(double seconds);

  [[nodiscard]] bool over() const { return elapsed_ >= kSeconds; }

  [[nodiscard]] const Camera& goal() const { return to_; }

  static constexpr double kSeconds = 0.3;

 private:
  Camera from_;
  Camera to_;
  double elapsed_ = 0;
};

}  // namespace soms::view
