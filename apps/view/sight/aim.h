/// \file
/// Cameras on a body or a contact: from which side it is seen, and what is cut away.
#pragma once

#include "soms/base/box.h"
#include "soms/base/parallel.h"
#include "soms/base/vector.h"

#include "apps/view/drawing/camera.h"
#include "apps/view/scene/part_boxes.h"
#include "apps/view/scene/touch.h"
#include "apps/view/scene/view_scene.h"

#include <optional>
#include <span>
#include <vector>

namespace soms::view {

/// What a camera looks at: what must not be hidden, and what shall be in the picture.
struct Aim {
  std::vector<Vec3> points;
  Box around;
  BodyRef body;
  bool is_middle = false;             ///< the one point is the body's own middle
  std::optional<PartPair> pair = {};  ///< of a contact: the two that touch most
  Box whole = {};                     ///< of the bodies that touch: nothing of it is cut away
};

/// A body where it touches others: places on the curves of the contacts, and the parts of the body
/// that touch, of long ones what is near the curves. \pre `touches` are contacts of the body, at
/// least one.
[[nodiscard]] Aim aim_at_touches(const ViewScene& scene, BodyRef body,
                                 const std::vector<Touch>& touches, PartBoxes& part_boxes);

/// The sides that may be looked from.
struct Sides {
  double bearing = 215;    ///< of the eye, degrees from north (+y) to east (+x): the first one
  double elevation = 30;   ///< of the eye, degrees above the horizon
  bool all_around = true;  ///< others, too, if more is seen from them
  bool may_cut = false;    ///< where next to nothing is seen, what is before it is cut away
};

/// A camera, and what it looks at.
struct AimedCamera {
  Camera camera;
  Box around = {};                    ///< of the aim that was chosen
  std::optional<PartPair> pair = {};  ///< likewise
};

/// A camera on the first of the aims that is seen well, in the open, with its surroundings; else on
/// the one that is seen best. Of sides that are about alike it is the first. From a single side an
/// aim that is not hidden is good enough.
/// \pre     At least one aim.
/// \errors  ErrorKind::cancelled.
/// \cost    Some 50 cameras an aim, a ray each for every point of the aim.
[[nodiscard]] AimedCamera aimed_camera(const ViewScene& scene, std::span<const Aim> aims,
                                       const Sides& sides, const FitCamera& fit,
                                       const Limits& limits = {});

/// The direction from a subject to an eye, of length 1: degrees from north (+y) to east (+x), and
/// above the horizon.
[[nodiscard]] Vec3 toward_eye(double bearing, double elevation);

/// Bounds of all bodies of a scene.
[[nodiscard]] Box scene_bounds(const ViewScene& scene);

}  // namespace soms::view
