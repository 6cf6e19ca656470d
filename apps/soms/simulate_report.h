/// \file
/// What a simulation tells: a table for people, an object for programs, a list of contacts.
#pragma once

#include "apps/soms/simulate.h"
#include "apps/soms/simulate_run.h"
#include "apps/support/world.h"

#include <ostream>
#include <string>

namespace soms::command {

/// The table that is read in ten seconds.
[[nodiscard]] std::string table_of(const World& world, const Outcome& outcome,
                                   const SimulateOptions& options);

/// One line of JSON, schema soms.simulate/1.
[[nodiscard]] std::string json_of(const World& world, const Outcome& outcome,
                                  const SimulateOptions& options);

/// CSV, a row a contact: mover, model, touched, part, triangle, begin, end. Frames count from 0;
/// `end` is the last frame of touch.
void write_events(std::ostream& out, const World& world, const Outcome& outcome);

}  // namespace soms::command
