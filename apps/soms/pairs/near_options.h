/// \file
/// Options that `distance` and `within` share.
#pragma once

#include "apps/soms/pairs/pair_options.h"

namespace soms::command {

/// Adds what follows the options of the question: -o, --shard, --verify, and those of the models.
void add_near_options(Parser& parser, PairOptions& options);

}  // namespace soms::command
