/// \file
/// What a simulation tells: a table for people, an object for programs, a list of contacts.
#pragma once

#include "apps/soms/simulate.h"
#include "apps/soms/simulate_run.h"
#include "apps/support/world.h"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// A name and what is told; an empty name goes on with the one before.
using Figure = std::pair<std::string, std::string>;
using Figures = std::vector<Figure>;

/// What a simulation found, line by line.
[[nodiscard]] Figures figures_of(const World& world, const Outcome& outcome,
                                 const SimulateOptions& options);

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
