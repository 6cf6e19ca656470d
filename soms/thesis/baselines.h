/// \file
/// The baselines: depth first, left before right, a pair is tested when it is entered. Which node
/// of an overlapping pair is descended differs; the rest is common.
///
/// Each traverses by an explicit stack, or with `options.recursive` by recursion: the same pairs in
/// the same order, the same counts but `max_stack`. Without `options.prune` children are entered
/// though the boxes are apart; answers are the same (thesis, fig. 4.35).
/// \source Ericson 2005, section 6.3.
#pragma once

#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"

namespace soms::detail {

/// Opens the first tree down to its leaves, then the second.
TraversalCounts a_first(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                        const TraversalVisitor& visitor, TraversalWorkspace& workspace);

/// Opens the second tree down to its leaves, then the first.
TraversalCounts b_first(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                        const TraversalVisitor& visitor, TraversalWorkspace& workspace);

/// Opens the trees in turn, the first tree first.
TraversalCounts alternate(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                          const TraversalVisitor& visitor, TraversalWorkspace& workspace);

/// Opens the node whose unmoved box has the greater volume; the first in a tie.
TraversalCounts larger(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                       const TraversalVisitor& visitor, TraversalWorkspace& workspace);

/// Opens both nodes at once: LL, LR, RL, RR.
TraversalCounts simultaneous(const PosedTree& a, const PosedTree& b,
                             const TraversalOptions& options, const TraversalVisitor& visitor,
                             TraversalWorkspace& workspace);

/// The generic traversal: any rule above, by `options.ericson_rule`.
TraversalCounts ericson(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                        const TraversalVisitor& visitor, TraversalWorkspace& workspace);

}  // namespace soms::detail
