/// \file
/// The verb `solid`: how do two closed models stand to each other?
#pragma once

#include "soms/query/solid.h"

#include "apps/cli/verb.h"
#include "apps/soms/pairs/pair_options.h"

#include <string>

namespace soms::command {

/// Options of the verb `solid`.
struct SolidVerbOptions : PairOptions {
  bool by_part = false;
  bool fail_if_solid = false;
};

[[nodiscard]] Action add_solid(Parser& parser, Shared& shared);
[[nodiscard]] int run_solid(const SolidVerbOptions& options, Console& console);

}  // namespace soms::command
