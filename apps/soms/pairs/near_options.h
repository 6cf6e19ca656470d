/// \file
/// Options that `distance` and `within` share.
#pragma once

#include "apps/soms/pairs/pair_options.h"

#include <string>

namespace soms::command {

/// Two models at rows of poses, and where answers about their distance go.
struct NearOptions : PairOptions {
  std::string csv = {};     ///< empty: none
  std::string binary = {};  ///< likewise
  std::string report = {};  ///< likewise
};

/// Adds what follows the options of the question: --report, --csv, --binary, --verify, and those of
/// the models.
void add_near_options(Parser& parser, NearOptions& options);

}  // namespace soms::command
