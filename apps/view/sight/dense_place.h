/// \file
/// Where a picture of a scene has something to show, if most of the scene is empty.
#pragma once

#include "soms/base/box.h"

#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <optional>

namespace soms::view {

/// A place of a sparse scene, and what lies elsewhere.
struct DensePlace {
  Box box;  ///< bounds of the city's triangles that are there
  std::uint64_t triangles_left = 0;
  std::uint64_t movers_left = 0;

  [[nodiscard]] bool operator==(const DensePlace&) const = default;
};

/// Of a city of few places far apart, as a selection of buildings is, the place that holds most:
/// seen as a whole, such a city is dots. The city is seen from above as a square grid; contacts
/// count most, then movers, then surfaces. Nothing where surfaces, or what they reach across, cover
/// more than a small part of the grid: then the whole is the picture.
/// \cost O(triangles of the city).
[[nodiscard]] std::optional<DensePlace> dense_place(const ViewScene& scene);

}  // namespace soms::view
