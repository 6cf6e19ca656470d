/// \file
/// Handles to move an object by hand: three arrows, three squares and a ring, by rays alone.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <array>
#include <optional>

namespace soms::view {

/// Parts of the gizmo that can be dragged.
enum class Handle {
  axis_x,
  axis_y,
  axis_z,
  plane_yz,
  plane_zx,
  plane_xy,
  turn,  ///< the ring: about the z axis
};

inline constexpr std::array<Handle, 7> kHandles{
    Handle::axis_x,   Handle::axis_y,   Handle::axis_z, Handle::plane_yz,
    Handle::plane_zx, Handle::plane_xy, Handle::turn};

/// The handles about a place, along the axes of the world.
struct Gizmo {
  Vec3 center;
  double size = 1;  ///< length of an arrow
};

/// The gizmo of a place whose arrows look `pixels` long; nothing for a place behind the eye.
[[nodiscard]] std::optional<Gizmo> gizmo_at(const Camera& camera, Size size, const Vec3& center,
                                            double pixels);

/// The handle under a pixel, within `slack` pixels for arrows and ring. Arrows win over squares,
/// squares over the ring. An arrow seen nearly end-on and a plane seen nearly edge-on cannot be
/// dragged with any sense, and are not hit.
[[nodiscard]] std::optional<Handle> handle_at(const Gizmo& gizmo, const Camera& camera, Size size,
                                              PixelPoint pixel, double slack);

/// Drawing of the gizmo: lines and squares seen through everything; the chosen handle is brighter.
void draw(const Gizmo& gizmo, std::optional<Handle> chosen, DrawList& list);

/// Ends of the arrows, for their letters.
[[nodiscard]] std::array<Vec3, 3> tips(const Gizmo& gizmo);

/// A handle that is being dragged.
class GizmoDrag {
 public:
  /// \pre `handle_at` gave the handle for this ray.
  GizmoDrag(const Gizmo& gizmo, Handle handle, const Pose& object, const Ray& ray);

  [[nodiscard]] Handle handle() const { return handle_; }

  /// The object as it was when the drag began.
  [[nodiscard]] const Pose& start() const { return start_; }

  /// Where the object is when the mouse is on `ray`: the grabbed point stays under it as far as the
  /// handle allows. Where the ray says nothing (parallel to the plane or axis, or beyond the
  /// horizon) the answer of before holds.
  [[nodiscard]] Pose dragged(const Ray& ray);

 private:
  Gizmo gizmo_;
  Handle handle_;
  Pose start_;
  Pose last_;
  Vec3 grabbed_;  ///< point of the axis or plane where it was taken
};

/// Point of the line through `origin` along `axis` (of length 1) that is nearest to the ray;
/// nothing where they are nearly parallel or that point of the ray is behind its origin.
[[nodiscard]] std::optional<Vec3> nearest_on_axis(const Ray& ray, const Vec3& origin,
                                                  const Vec3& axis);

/// Where the ray meets the plane through `origin` with the normal `normal` (of length 1); nothing
/// where it is nearly parallel, or leads away.
[[nodiscard]] std::optional<Vec3> meet_plane(const Ray& ray, const Vec3& origin,
                                             const Vec3& normal);

/// The pose after a turn by `angle` radians counter-clockwise about the vertical line through
/// `center`. Built from the rotation again and made rigid, so that a thousand turns do not drift.
[[nodiscard]] Pose turned_about(const Pose& pose, const Vec3& center, double angle);

/// The pose moved by an offset.
[[nodiscard]] Pose shifted(const Pose& pose, const Vec3& offset);

}  // namespace soms::view
