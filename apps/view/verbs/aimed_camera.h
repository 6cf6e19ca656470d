/// \file
/// Cameras on a mover or a contact: from which side, and what is cut away.
#pragma once

#include "apps/view/verbs/render_camera.h"

namespace soms::view {

/// The direction from a subject to an eye, of length 1: degrees from north (+y) to east (+x), and
/// above the horizon.
[[nodiscard]] Vec3 toward_eye(double bearing, double elevation);

/// Length of a vector.
[[nodiscard]] double line_length(const Vec3& v);

/// A camera on a mover, from a side from which it is seen, if there is one, or with what is before
/// it cut away. \errors ErrorKind::usage for a mover that is not there.
[[nodiscard]] Camera at_mover(const CameraChoice& choice, const ViewScene& scene, Size size,
                              const Parallel& parallel);

/// A camera on the mover with most contacts of those that are seen well, in the open; else on the
/// one that is seen best; where next to nothing of them is seen, with what is before it cut away.
/// \errors ErrorKind::usage where nothing touches.
[[nodiscard]] Camera at_contact(const CameraChoice& choice, const ViewScene& scene, Size size,
                                const Parallel& parallel);

}  // namespace soms::view
