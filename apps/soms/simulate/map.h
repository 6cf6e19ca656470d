/// \file
/// A picture of a simulation from above, as SVG.
#pragma once

#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

#include <ostream>

namespace soms::command {

/// Draws the city, shaded by height above its ground and simplified so that the file stays below
/// about 300 KB however many triangles there are; tracks and last places of the movers, their
/// contacts, the list of the most touched triangles that the table has, and the least gap of each
/// two bodies that are near each other without a touch.
void draw_map(std::ostream& out, const World& world, const Outcome& outcome);

}  // namespace soms::command
