/// \file
/// Where on the Earth the numbers of a file lie, as the file states it: recorded, never applied.
#pragma once

#include "soms/base/vector.h"

#include <iosfwd>
#include <optional>
#include <string>

namespace soms {

/// How a file places its numbers in a map (IfcMapConversion). With the x axis toward
/// (`abscissa`, `ordinate`), of length 1 once divided, a point (x, y, z) of the file lies at
///   east:   eastings  + scale (abscissa factors.x x - ordinate factors.y y)
///   north:  northings + scale (ordinate factors.x x + abscissa factors.y y)
///   height: height    + scale factors.z z
/// with x, y and z in the unit of the file, which a reader may have converted since.
struct MapConversion {
  double eastings = 0;       ///< of the origin, in units of the map
  double northings = 0;      ///< of the origin, in units of the map
  double height = 0;         ///< of the origin, in units of the map
  double abscissa = 1;       ///< east part of the direction of the x axis
  double ordinate = 0;       ///< north part of the direction of the x axis
  double scale = 1;          ///< units of the map for a unit of the file
  Vec3 factors = {1, 1, 1};  ///< more of it, for each axis of the file
  double unit = 0;           ///< meters a unit of the map; 0: not known

  [[nodiscard]] bool operator==(const MapConversion&) const = default;
};

/// What a file states about where its numbers lie on the Earth.
struct Georeference {
  std::string crs = {};  ///< the coordinate reference system: "EPSG:25833"; may be empty
  std::string vertical_datum =
      {};  ///< what heights begin at, where it is named apart; may be empty
  /// From the numbers to coordinates of `crs`; without it they are such coordinates.
  std::optional<MapConversion> map_conversion = std::nullopt;

  /// True if nothing is stated.
  [[nodiscard]] bool empty() const {
    return crs.empty() && vertical_datum.empty() && !map_conversion;
  }

  [[nodiscard]] bool operator==(const Georeference&) const = default;
};

/// The georeference of numbers that were multiplied by `scale`: its map conversion divides by it.
/// Nothing that is stated stays nothing.
/// \pre `scale` is finite and positive.
[[nodiscard]] Georeference scaled(Georeference georeference, double scale);

/// In words: "EPSG:25833; origin at east 311988, north 5996148, height 10"; "none" if nothing
/// is stated.
[[nodiscard]] std::string describe(const Georeference& georeference);

}  // namespace soms
