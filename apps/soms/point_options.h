/// \file
/// Options of verbs that ask about points beside one model.
#pragma once

#include "soms/base/pose.h"
#include "soms/tree/build_options.h"

#include "apps/support/models.h"
#include "apps/support/verb.h"

#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

/// Answers that the text output lists: as many as a person may want to read.
inline constexpr std::uint64_t kPointsInText = 20;

/// A model at a pose, and points.
struct PointOptions {
  std::string model;
  std::string points;
  std::optional<std::string> pose;  ///< unset: not moved
  bool verify = false;
  ModelOptions reading;
  BuildOptions build;
};

/// Adds MODEL, --points and --pose. `model` says in the help what kind of model is needed.
void add_points(CLI::App& app, PointOptions& options, const std::string& model);

/// Adds what follows the options of the question: --verify, and those of the model and its tree.
void add_point_options(CLI::App& app, PointOptions& options);

/// Settles the options once they are parsed. \errors ErrorKind::usage for standard input given
/// twice.
void check_point_options(CLI::App& app, PointOptions& options);

/// The pose that --pose gives, by its text or a file of one row.
/// \errors As `PoseSource`; ErrorKind::usage for more than one row.
[[nodiscard]] Pose stated_pose(const PointOptions& options, const Console& console);

}  // namespace soms::command
