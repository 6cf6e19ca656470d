/// \file
/// Where movers start and where they go.
#pragma once

#include "soms/generate/city.h"

#include "apps/cli/console.h"
#include "apps/world/world.h"

namespace soms::command {

/// Gives `world` its routes: by --route as they stand there, else along the streets of `city`, else
/// (null) on straight level lines. Except with --route every mover starts free: touching neither
/// the city nor another mover, as a query of the scene determines; who finds no room is left out
/// with a note. Deterministic in --seed.
void plan_routes(World& world, const WorldOptions& options, const City* city, Console& console);

}  // namespace soms::command
