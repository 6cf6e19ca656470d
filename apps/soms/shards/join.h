/// \file
/// The verb `join`: the answers of all shards as one.
#pragma once

#include "apps/cli/verb.h"

#include <string>

namespace soms::command {

/// Options of the verb `join`.
struct JoinOptions {
  std::string folder;
  std::string output;
};

[[nodiscard]] Action add_join(Parser& parser, Shared& shared);
[[nodiscard]] int run_join(const JoinOptions& options, Console& console);

}  // namespace soms::command
