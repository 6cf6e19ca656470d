/// \file
/// Cars and vans of one shape at two levels of detail: parked in paved streets, and as movers.
#pragma once

#include "soms/generate/detail/solids.h"

#include <cstdint>

namespace soms::detail {

/// How much of a vehicle is made.
enum class Finish {
  parked,  ///< body, round wheels, mirrors
  full,    ///< finer wheels with hubs, lamps and bumpers, too
};

/// Kinds of vehicles.
enum class Vehicle { sedan, van };

/// Triangles of a vehicle; the same for both kinds.
[[nodiscard]] std::uint64_t vehicle_triangles(Finish finish);

/// Appends a vehicle that stands on the frame's x-y plane and heads along its x; `stretch` scales
/// its length. Every part is closed; with `names`, each becomes a part of the mesh.
void add_vehicle(Mesh& mesh, const Frame& frame, Vehicle kind, Finish finish, double stretch = 1,
                 bool names = false);

}  // namespace soms::detail
