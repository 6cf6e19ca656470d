/// \file
/// Where to look at a contact or a gap of a scene, and how much around it is worth seeing.
#pragma once

#include "soms/base/box.h"

#include "apps/report/scene.h"

#include <span>

namespace soms::report {

/// A place, and the distance around it that a picture of it shows; in the coordinates of the scene.
struct Sight {
  Vec3 focus;
  double reach = 0;
};

/// The middle of where the first pair of triangles cross. `bounds` are those of the models of
/// `scene`, `size` is the diameter of what is drawn.
[[nodiscard]] Sight sight_of(const SceneContact& contact, const Scene& scene,
                             std::span<const Box> bounds, double size);

/// The place of a row whose pairs are known: all of its box is seen, and enough of the bodies.
[[nodiscard]] Sight sight_of(const SceneRow& row, const Scene& scene, std::span<const Box> bounds,
                             double size);

/// The middle of the segment: all of it is seen, and enough of the bodies to tell what is near
/// what.
[[nodiscard]] Sight sight_of(const SceneGap& gap, const Scene& scene, std::span<const Box> bounds,
                             double size);

}  // namespace soms::report
