/// \file
/// The verb `tile`: cuts models into tiles, for questions about more triangles than memory holds.
#pragma once

#include "soms/tiles/cut_tiles.h"

#include "apps/cli/verb.h"
#include "apps/model/models.h"

#include <string>
#include <vector>

namespace soms::command {

/// Options of the verb `tile`.
struct TileVerbOptions {
  std::vector<std::string> inputs;
  std::string output;
  ModelOptions model;
  CutOptions cut;
  bool compact = false;
};

[[nodiscard]] Action add_tile(Parser& parser, Shared& shared);
[[nodiscard]] int run_tile(const TileVerbOptions& options, Console& console);

}  // namespace soms::command
