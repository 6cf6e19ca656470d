/// \file
/// Nodes that a rule leaves undivided, and whether a plane could part their triangles.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/build_options.h"
#include "soms/tree/tree.h"

#include <cstdint>

namespace soms::reproduce {

/// Nodes of a tree whose rule left one side empty.
struct StuckNodes {
  std::uint64_t all = 0;
  std::uint64_t partable = 0;  ///< of them, those whose triangles do not all have one midpoint
  std::uint64_t largest = 0;   ///< triangles of the largest of `all`
};

/// Counts them. \pre `tree` is that of `mesh` by `options`, which are not `chain`.
/// \source  thesis, tables 5.5 and 5.11: nodes that "cannot be divided".
[[nodiscard]] StuckNodes stuck_nodes(const Tree& tree, const Mesh& mesh,
                                     const BuildOptions& options);

}  // namespace soms::reproduce
