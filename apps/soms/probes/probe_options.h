/// \file
/// Options of verbs that ask about points or rays beside one model.
#pragma once

#include "soms/base/pose.h"
#include "soms/tree/build_options.h"

#include "apps/cli/verb.h"
#include "apps/model/models.h"
#include "apps/rows/answer_outputs.h"

#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

/// Answers that the text output lists: as many as a person may want to read.
inline constexpr std::uint64_t kProbesInText = 20;

/// A model at a pose.
struct ProbeOptions {
  std::string model;
  std::optional<std::string> pose;  ///< unset: not moved
  AnswerOutputs outputs = {};
  bool verify = false;
  ModelOptions reading;
  BuildOptions build;
};

/// A model at a pose, and points.
struct PointOptions : ProbeOptions {
  std::string points;
};

/// Adds MODEL. `model` says in the help what kind of model is needed.
void add_probed_model(Parser& parser, ProbeOptions& options, const std::string& model);

/// Adds the option that names a file of rows: "--points", "points", "x,y,z".
Option* add_rows(Parser& parser, const std::string& name, std::string& target,
                 const std::string& what, const std::string& header);

/// Adds --pose.
void add_model_pose(Parser& parser, ProbeOptions& options);

/// Adds MODEL, --points and --pose.
void add_points(Parser& parser, PointOptions& options, const std::string& model);

/// Adds what follows the options of the question: -o, --verify, and those of the model and its
/// tree.
void add_probe_options(Parser& parser, ProbeOptions& options);

/// Settles the options once they are parsed. `rows` is the file of rows that
/// `rows_option` names.
/// \errors ErrorKind::usage for standard input given twice, or as `check_answer_outputs`.
void check_probe_options(Parser& parser, ProbeOptions& options, const std::string& rows_option,
                         const std::string& rows);

/// The pose that --pose gives, by its text or a file of one row.
/// \errors As `PoseSource`; ErrorKind::usage for more than one row.
[[nodiscard]] Pose stated_pose(const ProbeOptions& options, const Console& console);

}  // namespace soms::command
