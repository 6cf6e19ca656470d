/// \file
/// The side from which a place is seen.
#pragma once

#include "soms/base/vector.h"

#include "apps/view/scene/view_scene.h"

namespace soms::view {

/// A direction from a place to an eye that is `distance` away and sees it with nothing between, as
/// far as there is one: of all around and above, that from which most of the neighborhood within
/// `reach` of the place is seen. Of equally good ones it is the first, from a corner.
/// \cost Some 400 rays.
[[nodiscard]] Vec3 open_side(const ViewScene& scene, const Vec3& place, double reach,
                             double distance);

}  // namespace soms::view
