/// \file
/// The verb `distance`: how far apart are two models?
#pragma once

#include "apps/cli/verb.h"
#include "apps/soms/pairs/near_options.h"

#include <limits>

namespace soms::command {

/// Options of the verb `distance`.
struct DistanceVerbOptions : PairOptions {
  double at_most = std::numeric_limits<double>::infinity();
};

[[nodiscard]] Action add_distance(Parser& parser, Shared& shared);
[[nodiscard]] int run_distance(const DistanceVerbOptions& options, Console& console);

}  // namespace soms::command
