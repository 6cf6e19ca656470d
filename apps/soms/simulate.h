/// \file
/// The verb `simulate`: a city, movers on its streets, frame by frame: who touches what, when.
#pragma once

#include "apps/soms/models.h"
#include "apps/soms/verbs.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

/// Options of the verb `simulate`.
struct SimulateOptions {
  std::vector<std::string> cities = {};  ///< none: the embedded city
  std::vector<std::string> movers = {};  ///< none: generated cars, persons and drones
  std::vector<std::string> routes = {};
  std::optional<std::uint64_t> count = std::nullopt;
  std::uint64_t frames = 600;
  ModelOptions city_model = {};   ///< an unknown axis is what the file says
  ModelOptions mover_model = {};  ///< likewise
  bool verify = false;
  std::string map = {};     ///< empty: none
  std::string events = {};  ///< empty: none
  bool fail_if_contact = false;
};

/// Frames of a second of simulated time.
inline constexpr double kFramesASecond = 60;

[[nodiscard]] Action add_simulate(CLI::App& app, Shared& shared);
[[nodiscard]] int run_simulate(const SimulateOptions& options, Console& console);

}  // namespace soms::command
