/// \file
/// Street furniture of a generated city: lamps, trees, benches, signs, bins, parked vehicles.
#pragma once

#include "soms/generate/city.h"
#include "soms/generate/detail/solids.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// Kinds of street furniture.
enum class FurnitureKind { lamp, tree, bench, sign, bin, car, van };

/// A piece of furniture before its triangles are made.
struct Furniture {
  FurnitureKind kind = FurnitureKind::lamp;
  std::uint64_t index = 0;  ///< number of its bay: what its shape is drawn from
  Frame frame;              ///< on the road, x along the street, y toward the houses
};

/// Triangles of a piece.
[[nodiscard]] std::uint64_t furniture_triangles(FurnitureKind kind, CityStreets streets);

/// Pieces in bays along the streets, 6 m clear of crossings, of at most `budget` triangles
/// together.
[[nodiscard]] std::vector<Furniture> plan_furniture(const City& city, std::uint64_t budget);

/// Appends the part `furniture`, one part a piece.
void add_furniture(City& city, const std::vector<Furniture>& pieces, const Limits& limits);

}  // namespace soms::detail
