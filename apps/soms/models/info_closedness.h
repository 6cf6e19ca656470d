/// \file
/// What `info` tells of a model's closedness: whether points can be inside, and if not, why.
#pragma once

#include "soms/geometry/closedness.h"
#include "soms/geometry/mesh.h"

#include "apps/output/json.h"
#include "apps/soms/models/info_defects.h"

#include <string>

namespace soms::command {

class Console;

/// The member `closedness` of the JSON.
[[nodiscard]] Json closedness_json(const ExaminedMesh& mesh, const Closedness& found);

/// Whether "inside" is defined, in one line.
[[nodiscard]] std::string describe_closedness(const Closedness& found);

/// Prints the first odd edges, where there are others than the `open_edges` that are printed
/// already.
/// \errors ErrorKind::cancelled; those of Console::print.
void print_odd_edges(const ExaminedMesh& mesh, const Closedness& found, std::uint64_t open_edges,
                     Console& console);

}  // namespace soms::command
