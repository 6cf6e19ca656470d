/// \file
/// States of a robot as text, JSON and CSV.
#pragma once

#include "soms/base/error.h"
#include "soms/robot/robot_query.h"

#include "apps/cli/terminal.h"
#include "apps/output/json.h"
#include "apps/soms/robot/robot_models.h"
#include "apps/soms/robot/robot_way.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace soms::command {

/// What was found over all states.
struct RobotTotals {
  std::uint64_t states = 0;
  std::uint64_t free = 0;
  std::uint64_t contact = 0;
  std::uint64_t undecided = 0;
  std::uint64_t open = 0;                         ///< undecided, though there was time
  std::uint64_t cut = 0;                          ///< for lack of time
  std::uint64_t beyond_limits = 0;                ///< states
  std::map<RobotPair, std::uint64_t> pairs;       ///< that touch: in how many states
  std::map<std::uint32_t, std::uint64_t> limits;  ///< joints beyond: in how many states
  std::optional<std::uint64_t> first_contact;     ///< the first state with one
  std::optional<std::uint64_t> first_undecided;   ///< the first state that was not decided
  std::optional<std::pair<std::uint64_t, RobotGap>> least;  ///< the least gap, and its first state
  std::optional<std::pair<std::uint64_t, RobotGap>>
      least_free;  ///< the same of states without contact
  Cost cost;

  void add(const RobotAnswer& answer);
};

/// What is said beside the answers.
struct RobotReport {
  const RobotModels& models;
  RobotTotals totals = {};
  std::optional<PathTotals> path = std::nullopt;  ///< of a path
  bool distance = false;
  bool verified = false;  ///< every answer was compared with brute force, and is equal
  bool interrupted = false;
  bool timed_out = false;
};

/// "joint elbow is 3.2, outside of its limits -3 and 3". The state has one value a movable joint.
[[nodiscard]] std::string limit_in_words(const RobotModels& models, std::uint32_t joint,
                                         std::span<const double> state);

/// The two of a pair: "arm and cell: wall", as `a` and `b`, and as two columns, which may be empty.
[[nodiscard]] std::string pair_in_text(const RobotModels& models, const RobotPair& pair);
[[nodiscard]] Json pair_as_json(const RobotModels& models, const RobotPair& pair);
[[nodiscard]] std::string pair_as_csv(const RobotModels& models,
                                      const std::optional<RobotPair>& pair);

/// What is compared, for people: some lines.
[[nodiscard]] std::string models_in_text(const RobotModels& models);

/// A line for a state.
[[nodiscard]] std::string answer_in_text(const RobotModels& models, std::uint64_t state,
                                         const RobotAnswer& answer, const Terminal& terminal = {});

/// Lines for all states.
[[nodiscard]] std::string totals_in_text(const RobotReport& report);

/// What is wrong where states are undecided because bodies are open.
[[nodiscard]] std::optional<Error> open_warning(const RobotReport& report);

/// An object for a state (soms.robot/1). `verified` is left out where brute force did not look.
[[nodiscard]] Json answer_as_json(const RobotModels& models, std::uint64_t state,
                                  const RobotAnswer& answer, std::optional<bool> verified);

/// The last object, which counts.
[[nodiscard]] Json totals_as_json(const RobotReport& report);

/// The header of CSV, and a row for a state.
[[nodiscard]] std::string robot_csv_header();
[[nodiscard]] std::string answer_as_csv(const RobotModels& models, std::uint64_t state,
                                        const RobotAnswer& answer);

}  // namespace soms::command
