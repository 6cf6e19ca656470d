/// \file
/// `soms reproduce`: the experiments of the thesis as tables, figures and a page.
#pragma once

#include "apps/cli/verb.h"

#include <string>
#include <vector>

namespace soms::command {

struct ReproduceOptions {
  std::string models;              ///< folder; empty: stand-ins
  std::vector<std::string> items;  ///< empty: all
  std::string output = "soms-thesis";
  bool quick = false;
  std::string report = {};  ///< empty: none
  bool latex = false;
  std::string pdf = {};     ///< empty: none
  std::string golden = {};  ///< folder of golden tables; empty: none
};

Action add_reproduce(Parser& parser, Shared& shared);

/// Runs the experiments. Status 130 if it was interrupted, 4 if time ran out; what is written by
/// then is whole. Status 3 if a count differs from the golden tables.
int run_reproduce(const ReproduceOptions& options, Console& console);

}  // namespace soms::command
