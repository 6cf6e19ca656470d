/// \file
/// E-Node that descends on while only one child pair overlaps: a reading of "Earlier Node
/// detection" that the library does not have.
#pragma once

#include "soms/thesis/pair_traversal.h"

namespace soms::reproduce {

/// Tests and reports exactly what Traversal::e_node does with descent both, in the same order. If
/// one child pair alone is to be divided, it takes the place of its parent at once: it is not put
/// on the stack or called for, and does not count as entered. By an explicit stack, or by recursion
/// as deep as the trees, with the same tests, reports and entries.
/// \errors ErrorKind::usage for boxes that are not as many as nodes.
/// \source ours. The thesis does not say what E-Node does.
TraversalCounts e_node_chain(const PosedTree& a, const PosedTree& b, bool recursive,
                             const TraversalVisitor& visitor, TraversalWorkspace& workspace);

}  // namespace soms::reproduce
