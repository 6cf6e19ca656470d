/// \file
/// The step of E-Node, shared by its start at the roots and its start at a front.
#pragma once

#include "soms/thesis/detail/child_pairs.h"
#include "soms/thesis/detail/probe.h"
#include "soms/thesis/traversal_options.h"

#include <vector>

namespace soms::detail {

/// Enters the pairs on the stack, last first, and all that follows from them, until the stack is
/// empty or the visitor stops; then what is left on the stack was tested, overlaps, and was not
/// entered. \pre Every pair on the stack was tested and is not two leaves.
///
/// With `front`, appends each tested child pair where the descent ends: apart, or two leaves.
void enter_all(Probe& probe, const TraversalOptions& options, std::vector<NodePair>& stack,
               std::vector<NodePair>* front);

}  // namespace soms::detail
