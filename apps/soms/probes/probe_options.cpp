#include "apps/soms/probes/probe_options.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/shared.h"
#include "apps/model/part_filter.h"
#include "apps/rows/pose_source.h"
#include "apps/soms/pairs/pair_options.h"

#include <algorithm>
#include <array>

namespace soms::command {

void add_probed_model(Parser& parser, ProbeOptions& options, const std::string& model) {
  parser.add_option("MODEL", options.model, model + "; - is standard input")->required();
}

Option* add_rows(Parser& parser, const std::string& name, std::string& target,
                 const std::string& what, const std::string& header) {
  return parser
      .add_option(name, target,
                  what + ": CSV (header " + header + "), .npy or .npz; - is standard input")
      ->option_text("FILE")
      ->group(kQuestionGroup);
}

void add_model_pose(Parser& parser, ProbeOptions& options) {
  parser
      .add_option("--pose", options.pose,
                  "pose of the model: \"x y z [qw qx qy qz]\", or a file of one row")
      ->option_text("POSE")
      ->group(kQuestionGroup);
}

void add_points(Parser& parser, PointOptions& options, const std::string& model) {
  add_probed_model(parser, options, model);
  add_rows(parser, "--points", options.points, "points", "x,y,z")->required();
  add_model_pose(parser, options);
}

void add_probe_options(Parser& parser, ProbeOptions& options) {
  add_renamed_outputs(parser, options.outputs,
                      {AnswerFile::csv, AnswerFile::npz, AnswerFile::json, AnswerFile::lines},
                      kQuestionGroup);
  parser
      .add_flag("--verify", options.verify,
                "compare with brute force; exit with status 6 if they differ")
      ->group(kQuestionGroup);
  add_model_options(parser, options.reading, "--scale", "--up", "the model");
  add_allow_empty(parser, options.reading);
  add_strict(parser, options.reading.strict);
  add_part_filter(parser, options.reading.parts, "the model");
  add_tree_list(parser, options.build);
}

void check_probe_options(Parser& parser, ProbeOptions& options, const std::string& rows_option,
                         const std::string& rows) {
  options.reading.offers_empty = true;
  check_build(parser, options.build);
  const std::array<std::string, 3> inputs{options.model, rows, options.pose.value_or("")};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  check_answer_outputs(
      {{"MODEL", options.model}, {rows_option, rows}, {"--pose", options.pose.value_or("")}},
      options.outputs);
}

Pose stated_pose(const ProbeOptions& options, const Console& console) {
  if (!options.pose) {
    return {};
  }
  PoseSource source("--pose", *options.pose, console);
  const Pose pose = source.next().value_or(Pose{});
  if (!source.is_constant()) {
    throw Error(ErrorKind::usage, source.name() + ": has more than one pose",
                "give one pose of the model");
  }
  return pose;
}

}  // namespace soms::command
