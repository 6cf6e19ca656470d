/// \file
/// Options of the verbs that show trees.
#pragma once

#include "soms/thesis/traversal_options.h"
#include "soms/tree/build_options.h"

namespace CLI {
class App;
}  // namespace CLI

namespace soms::view {

/// Adds --thesis, and the options of trees and traversals, which change what it sets where they are
/// given, too.
void add_tree_options(CLI::App& app, BuildOptions& build, TraversalOptions& traversal);

/// \errors ErrorKind::usage as `check_build` and `check_traversal`. What --thesis set and the rule
/// does not use is no fault: it is brought back to its default.
void check_tree_options(const CLI::App& app, BuildOptions& build,
                        const TraversalOptions& traversal);

/// Says of --count how many movers are shown without it.
void describe_count(CLI::App& app);

}  // namespace soms::view
