/// \file
/// The sun and the ground of a still picture.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/scene/view_scene.h"

namespace soms::view {

/// Toward a sun at the left of the camera and a little behind it, so that shadows are seen from
/// every side. Where something hides that sun from the camera's target, one at the right, or
/// farther up; if all are hidden, the first.
[[nodiscard]] Vec3 sun_for(const Camera& camera, const ViewScene& scene);

/// Where movers stand over nothing little above `lowest`, as cars do in a city without streets, the
/// level of the one nearest to what the camera looks at; else `lowest`.
[[nodiscard]] double ground_level(const Camera& camera, const ViewScene& scene, double lowest);

}  // namespace soms::view
