/// \file
/// Traversals, their options and their counts, printed by `<<`.
#pragma once

#include "soms/thesis/traversal_options.h"

#include <iosfwd>

namespace soms {

struct NodePair;
struct TraversalCounts;
struct TraversalOptions;

/// One line, as in soms/base/print.h.
std::ostream& operator<<(std::ostream& out, const TraversalCounts& value);
std::ostream& operator<<(std::ostream& out, const NodePair& value);
std::ostream& operator<<(std::ostream& out, const TraversalOptions& value);

namespace thesis {

struct CountedOverlap;

std::ostream& operator<<(std::ostream& out, const CountedOverlap& value);

}  // namespace thesis

}  // namespace soms
