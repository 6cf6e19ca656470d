/// \file
/// Options that say what a simulation starts from.
#pragma once

#include "apps/model/models.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

class Parser;

/// City, movers and their routes, as named on the command line.
struct WorldOptions {
  std::vector<std::string> cities = {};  ///< none: the embedded city
  std::vector<std::string> movers = {};  ///< none: generated cars, persons and drones
  std::vector<std::string> routes = {};
  std::optional<std::uint64_t> count = std::nullopt;
  ModelOptions city_model = {};   ///< an unknown axis is what the file says
  ModelOptions mover_model = {};  ///< likewise
  BuildOptions build = {};
  bool guess_up = false;  ///< draw the one city, or two that agree, of unknown axis as it looks
  bool guess_mover_up = false;  ///< likewise models of --mover
  bool keep_trees = false;      ///< keep the canonical trees, which named traversals need
};

/// Adds CITY, --mover, --route, --count, --scale, --up, --mover-scale, --mover-up, --strict, --only
/// and --ignore.
void add_world_options(Parser& parser, WorldOptions& options);

}  // namespace soms::command
