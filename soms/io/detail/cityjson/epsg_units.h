/// \file
/// Units of the coordinate reference systems of the EPSG registry.
#pragma once

#include <cstdint>
#include <span>

namespace soms::detail {

/// Systems with codes that follow each other, whose axes have one unit.
struct EpsgRun {
  std::uint32_t first = 0;
  std::uint16_t count = 0;
  std::uint16_t unit = 0;  ///< for `epsg_meters`
};

/// Sorted by `first`, without overlaps. Codes that no run has are of no system, or of one with
/// lengths in several units.
[[nodiscard]] std::span<const EpsgRun> epsg_runs();

/// Meters a unit of all axes; 0 where axes are angles.
[[nodiscard]] double epsg_meters(const EpsgRun& run);

}  // namespace soms::detail
