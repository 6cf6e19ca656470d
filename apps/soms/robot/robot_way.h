/// \file
/// What is proved of a robot's ways from state to state, for people and for programs.
#pragma once

#include "soms/robot/robot_path.h"

#include "apps/output/json.h"
#include "apps/soms/robot/robot_models.h"

#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

/// A way, and the number of the state that it begins at.
struct RobotWay {
  std::uint64_t from = 0;
  RobotSegment segment = {};
};

/// What the ways of a path are together.
struct PathTotals {
  std::uint64_t free = 0;
  std::uint64_t contact = 0;  ///< on the way, or from its begin
  std::uint64_t undecided = 0;
  std::uint64_t cut = 0;                              ///< for lack of time, of all
  std::optional<RobotWay> blocked = std::nullopt;     ///< the first that is not free
  std::optional<std::uint64_t> state = std::nullopt;  ///< the first that is not free
  bool state_is_open = false;                         ///< that is undecided

  void add(const RobotWay& way);
  void add(std::uint64_t number, const RobotAnswer& answer);
};

/// Whether it is a contact, and whether that is not known.
[[nodiscard]] bool touches(const RobotSegment& segment);
[[nodiscard]] bool is_open(const RobotSegment& segment);

/// A line for a way where something happens on it; nothing else.
[[nodiscard]] std::string way_in_text(const RobotModels& models, const RobotWay& way);

/// A line for the path.
[[nodiscard]] std::string path_in_text(const RobotModels& models, const PathTotals& totals);

[[nodiscard]] Json way_as_json(const RobotModels& models, const RobotWay& way);
[[nodiscard]] Json path_as_json(const RobotModels& models, const PathTotals& totals);

/// Columns behind those of a state; with no way they are empty.
[[nodiscard]] std::string way_csv_header();
[[nodiscard]] std::string way_as_csv(const RobotModels& models, const std::optional<RobotWay>& way);

}  // namespace soms::command
