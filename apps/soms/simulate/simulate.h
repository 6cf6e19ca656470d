/// \file
/// The verb `simulate`: a city, movers on its streets, frame by frame: who touches what, when.
#pragma once

#include "apps/cli/verb.h"
#include "apps/rows/answer_outputs.h"
#include "apps/soms/pairs/traversal_by_name.h"
#include "apps/world/world_options.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// What ends `simulate` with status 1.
enum class FailIf {
  never,
  contact,  ///< or a passage
  near,     ///< a near event; a contact is one
};

/// Options of the verb `simulate`.
struct SimulateOptions {
  WorldOptions world = {};
  std::shared_ptr<const TraversalByName> traversal = nullptr;
  std::uint64_t frames = 600;  ///< unless given, routes of poses change it
  bool verify = false;
  std::string map = {};       ///< empty: none
  std::string events = {};    ///< empty: none
  std::string contacts = {};  ///< empty: none
  std::string record = {};    ///< empty: none
  std::string report = {};    ///< empty: none
  std::string answer = {};    ///< as JSON; empty: none
  bool view = false;          ///< in a window, instead of all else
  bool frames_given = false;
  std::vector<std::string> tree_words = {};  ///< options of trees and traversals, as given
  std::string picture = {};                  ///< empty: none
  std::optional<std::uint64_t> picture_frame = std::nullopt;  ///< unset: the last
  double clearance = 0;  ///< pairs at most this far apart are near; 0: none are
  bool swept = false;    ///< what is touched between two frames counts, too
  FailIf fail_if = FailIf::never;
  bool between_movers = true;             ///< test movers against each other
  std::vector<std::string> ignored = {};  ///< pairs of movers that are not, "A,B"
};

/// What -o of `simulate` writes.
[[nodiscard]] std::vector<OutputKind> simulate_files(SimulateOptions& options);

[[nodiscard]] Action add_simulate(Parser& parser, Shared& shared);
[[nodiscard]] int run_simulate(const SimulateOptions& given, Console& console);

}  // namespace soms::command
