/// \file
/// What a simulation tells: a table for people, an object for programs, a list of contacts.
#pragma once

#include "apps/cli/terminal.h"
#include "apps/soms/simulate/simulate.h"
#include "apps/soms/simulate/simulate_run.h"
#include "apps/world/world.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

/// A name and its value; an empty name goes on with the one before.
using Figure = std::pair<std::string, std::string>;
using Figures = std::vector<Figure>;

/// How many of the most touched triangles are reported, in the table, in JSON and on the map.
inline constexpr std::size_t kMostTouched = 5;

/// "triangle 17 of house 3".
[[nodiscard]] std::string name_of(const World& world, const Touched& touched);

/// "touched twice, for 39 frames in all". Frames count once for each mover.
[[nodiscard]] std::string counts_of(const Touched& touched);

/// What a simulation found, line by line.
[[nodiscard]] Figures figures_of(const World& world, const Outcome& outcome,
                                 const SimulateOptions& options);

/// The table that is read in ten seconds; on a `terminal`, as wide as it is; with `hints` a line on
/// how to look at it.
[[nodiscard]] std::string table_of(const World& world, const Outcome& outcome,
                                   const SimulateOptions& options, const Terminal& terminal,
                                   bool hints);

/// One line of JSON, schema soms.simulate/1.
[[nodiscard]] std::string json_of(const World& world, const Outcome& outcome,
                                  const SimulateOptions& options);

}  // namespace soms::command
