/// \file
/// Cameras of the command line on a mover or a contact.
#pragma once

#include "apps/view/sight/aim.h"
#include "apps/view/verbs/render_camera.h"

namespace soms::view {

/// A camera on a mover, from the side that was named, or else one from which it is seen, if there
/// is one, or with what is before it cut away. \errors ErrorKind::usage for a mover that is not
/// there.
[[nodiscard]] AimedCamera at_mover(const CameraChoice& choice, const ViewScene& scene, Size size,
                                   const Limits& limits);

/// A camera on the mover with most contacts of those that are seen well, in the open, from the side
/// that was named or any other; else on the one that is seen best; where next to nothing of them is
/// seen from any side, with what is before it cut away. Of one mover, or with `clash`, it is a pair
/// of parts, that with most pairs of triangles first.
/// \errors ErrorKind::usage where nothing touches, and for a `clash` that is not there.
[[nodiscard]] AimedCamera at_contact(const CameraChoice& choice, const ViewScene& scene, Size size,
                                     const Limits& limits);

}  // namespace soms::view
