/// \file
/// The verb `info`: what a model holds, what is wrong with it, and what its trees are like.
#pragma once

#include "soms/tree/build_options.h"

#include "apps/cli/verb.h"
#include "apps/model/models.h"

#include <cstddef>
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
  bool verify = false;      ///< of tree files: every box
  std::size_t places = 10;  ///< most places of each kind of defect to name
};

[[nodiscard]] Action add_info(Parser& parser, Shared& shared);
[[nodiscard]] int run_info(const InfoOptions& options, Console& console);

}  // namespace soms::command
