/// \file
/// The page of a simulation: what `-o FILE.html` writes.
#pragma once

#include "apps/soms/simulate/simulate.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

#include <cstddef>
#include <ostream>
#include <vector>

namespace soms::command {

/// Writes one HTML file with figures, plots, the time line and the scene with its contacts.
void write_page(std::ostream& out, const World& world, const Outcome& outcome,
                std::vector<std::size_t> event_of, const SimulateOptions& options);

}  // namespace soms::command
