/// \file
/// The verb `clearance`: how near a model comes to others along a path.
#pragma once

#include "apps/cli/verb.h"
#include "apps/soms/clearance/clearance_path.h"
#include "apps/world/world_options.h"

#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// What --fail-if waits for.
enum class ClearanceFailure { never, contact, below };

/// Options of the verb `clearance`.
struct ClearanceVerbOptions {
  WorldOptions world;   ///< CITY; its mover and route are the profile and the path
  std::string profile;  ///< file
  std::string path;     ///< file
  Forward forward = Forward::x;
  std::optional<double> every;     ///< unset: by the size of the profile
  std::optional<double> accuracy;  ///< likewise
  double clearance = 0;            ///< 0: none
  ClearanceFailure fail_if = ClearanceFailure::never;
  bool verify = false;
  std::string table;   ///< file of stations as CSV; empty: none
  std::string list;    ///< likewise, as a JSON document
  std::string lines;   ///< likewise, as JSON Lines
  std::string map;     ///< file; empty: none
  std::string report;  ///< likewise
};

[[nodiscard]] Action add_clearance(Parser& parser, Shared& shared);
[[nodiscard]] int run_clearance(const ClearanceVerbOptions& options, Console& console);

}  // namespace soms::command
