/// \file
/// Options of the named traversals, for the verbs that have them. The library soms_traversal_keys:
/// it links soms::thesis, which most of the command does without.
#pragma once

#include "soms/thesis/traversal_options.h"

namespace soms::command {

class Parser;

/// Adds --traversal and --descent.
void add_traversal_options(Parser& parser, TraversalOptions& options);

/// The same as keys of --tree, which `add_tree_list` has added.
void add_traversal_keys(Parser& parser, TraversalOptions& options);

/// \errors ErrorKind::usage for a --descent that the traversal does not have. Options that the
/// caller set beside those of the command line must go with every traversal.
void check_traversal(const Parser& parser, const TraversalOptions& options);

}  // namespace soms::command
