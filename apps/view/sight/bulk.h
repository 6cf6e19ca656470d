/// \file
/// The bulk of a city: what a picture of it should be as large as.
#pragma once

#include "soms/base/box.h"

#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <optional>

namespace soms::view {

/// Bounds of a city without what lies far from the rest.
struct CityBulk {
  Box box;
  std::uint64_t pieces_left = 0;  ///< parts, or connected pieces, that lie outside

  [[nodiscard]] bool operator==(const CityBulk&) const = default;
};

/// Of a city of 20 pieces or more, the bulk, if pieces are far off and at most one in twenty: those
/// whose middle is farther from the middle nine tenths, along x or y, than half as far as these
/// reach. Nothing where there are no such pieces. \cost Nearly linear in the triangles.
[[nodiscard]] std::optional<CityBulk> city_bulk(const ViewScene& scene);

}  // namespace soms::view
