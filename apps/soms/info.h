/// \file
/// The verb `info`: what a model holds, what is wrong with it, and what its trees are like.
#pragma once

#include "soms/tree/build_options.h"

#include "apps/support/models.h"
#include "apps/support/verb.h"

#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// Options of the verb `info`.
struct InfoOptions {
  std::vector<std::string> files;
  ModelOptions model;
  /// One triangle a leaf, so that the counts show what the rules do.
  BuildOptions build{.per_leaf = 1};
  bool every_rule = true;
  bool trees = true;
};

[[nodiscard]] Action add_info(CLI::App& app, Shared& shared);
[[nodiscard]] int run_info(const InfoOptions& options, Console& console);

}  // namespace soms::command
