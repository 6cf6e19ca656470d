/// \file
/// The parts of a city that a profile is compared with.
#pragma once

#include "soms/scene/clearance_along.h"

#include "apps/world/world.h"

#include <string>
#include <vector>

namespace soms::command {

class Console;

/// Bodies without the parts that are left out, and which triangles of the city theirs are.
struct ComparedCity {
  std::vector<Body> bodies;                        ///< as many as of the city
  std::vector<std::vector<TriangleId>> triangles;  ///< of each body; empty: all, in their order

  /// Gives the triangles of an answer the numbers that they have in the city.
  void rename(Clearance& answer) const;
};

/// The city without parts whose name, id or type, or that of a part around them, fits one of the
/// patterns of a shell; without patterns the city as it is.
/// \errors ErrorKind::usage for a pattern that fits nothing, and where nothing is left.
[[nodiscard]] ComparedCity compared_city(const World& world,
                                         const std::vector<std::string>& patterns,
                                         const Console& console);

}  // namespace soms::command
