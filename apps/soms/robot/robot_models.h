/// \file
/// A robot and its cell as the verb `robot` reads them.
#pragma once

#include "soms/kinematics/robot.h"
#include "soms/robot/robot_model.h"

#include "apps/model/frame_warnings.h"
#include "apps/model/models.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::command {

class Console;

/// How a robot and its cell are named and read.
struct RobotModelsOptions {
  std::string urdf;
  std::string srdf;                   ///< file; empty: none
  std::vector<std::string> packages;  ///< "NAME=DIR"
  std::vector<std::string> cell;      ///< files
  std::optional<std::string> base;    ///< pose of the root link; unset: the identity
  std::vector<std::string> ignored;   ///< "LINK,LINK"
  std::vector<std::string> off_cell;  ///< links
  double round_error = 0.0005;        ///< of round shapes, in meters
  ModelOptions reading;               ///< of the cell
};

/// A robot, its cell, and what is queried about them.
struct RobotModels {
  Robot robot;
  std::vector<Mesh> cell;
  RobotModel model;
  std::vector<std::string> cell_names = {};  ///< of each body of the cell
  std::vector<std::string> cell_files = {};  ///< of each body, the file that it is in
  std::vector<std::string> open = {};        ///< bodies that are not closed, as people call them
  std::vector<FrameWarning> warnings = {};
  std::vector<std::string> notes = {};

  /// The number of a link. \errors ErrorKind::usage naming `option`.
  [[nodiscard]] static std::uint32_t link_named(const Robot& robot, const std::string& option,
                                                const std::string& name);
};

/// \errors As `read_robot` and `read_model`; ErrorKind::usage for options that name what there is
///         not.
[[nodiscard]] RobotModels read_robot_models(const RobotModelsOptions& options, Console& console);

}  // namespace soms::command
