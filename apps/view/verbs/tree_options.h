/// \file
/// Options of the verbs that show trees.
#pragma once

#include "soms/thesis/traversal_options.h"
#include "soms/tree/build_options.h"

namespace soms::command {
class Parser;
}  // namespace soms::command

namespace soms::view {

/// Adds --thesis, and the options of trees and traversals, which change what it sets where they are
/// given, too.
void add_tree_options(command::Parser& parser, BuildOptions& build, TraversalOptions& traversal);

/// \errors ErrorKind::usage as `check_build` and `check_traversal`. What --thesis set and the rule
/// does not use is no fault: it is brought back to its default.
void check_tree_options(const command::Parser& parser, BuildOptions& build,
                        const TraversalOptions& traversal);

/// Says of --count how many movers are shown without it.
void describe_count(command::Parser& parser);

}  // namespace soms::view
