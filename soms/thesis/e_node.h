/// \file
/// E-Node: all child pairs of a pair are tested before any of them is entered.
#pragma once

#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"

namespace soms::detail {

/// E-Node from the roots. A pair is entered only when its boxes are known to overlap; overlapping
/// pairs of leaves among its child pairs are reported before anything deeper is looked at.
///
/// Which child pairs are tested is `options.descent`; the order of entry is `options.order`: left
/// before right, or greatest shared volume first. The thesis names E-Node ("Earlier Node
/// detection") in captions without pseudo code: this is a reconstruction.
///
/// Makes exactly as many box tests as the baseline that descends the same nodes: descent both as
/// `simultaneous`, descent larger as `larger`. By an explicit stack, or with `options.recursive` by
/// recursion: the same pairs in the same order, the same counts but `max_stack`.
/// \source thesis, section 4.5.2 and figs. 5.9, 5.10, by their captions.
TraversalCounts e_node(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                       const TraversalVisitor& visitor, TraversalWorkspace& workspace);

}  // namespace soms::detail
