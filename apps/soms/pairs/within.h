/// \file
/// The verb `within`: are two models within a clearance of each other?
#pragma once

#include "apps/cli/verb.h"
#include "apps/soms/pairs/near_options.h"

#include <string>

namespace soms::command {

/// Options of the verb `within`, and of `overlap --clearance`.
struct WithinVerbOptions : PairOptions {
  std::string verb = "within";  ///< as messages name it
  double clearance = 0;
  bool fail_if_within = false;
};

[[nodiscard]] Action add_within(Parser& parser, Shared& shared);
[[nodiscard]] int run_within(const WithinVerbOptions& options, Console& console);

}  // namespace soms::command
