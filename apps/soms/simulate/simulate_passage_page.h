/// \file
/// Passages on the page of a simulation.
#pragma once

#include "apps/report/scene.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

namespace soms::command {

/// Adds a row and a contact for each passage that no frame shows. \pre The events are there.
void add_passages(report::Scene& scene, const World& world, const Outcome& outcome);

}  // namespace soms::command
