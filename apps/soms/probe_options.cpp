#include "apps/soms/probe_options.h"

#include "soms/base/error.h"

#include "apps/soms/pair_options.h"
#include "apps/support/console.h"
#include "apps/support/pose_source.h"
#include "apps/support/shared.h"

#include <algorithm>
#include <array>

namespace soms::command {

void add_probed_model(CLI::App& app, ProbeOptions& options, const std::string& model) {
  app.add_option("MODEL", options.model, model + "; - is standard input")
      ->required()
      ->type_name("");
}

CLI::Option* add_rows(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& what, const std::string& header) {
  return app
      .add_option(name, target,
                  what + ": CSV (header " + header + "), .npy or .npz; - is standard input")
      ->option_text("FILE")
      ->group(kQuestionGroup);
}

void add_model_pose(CLI::App& app, ProbeOptions& options) {
  app.add_option("--pose", options.pose,
                 "pose of the model: \"x y z [qw qx qy qz]\", or a file of one row")
      ->option_text("POSE")
      ->group(kQuestionGroup);
}

void add_points(CLI::App& app, PointOptions& options, const std::string& model) {
  add_probed_model(app, options, model);
  add_rows(app, "--points", options.points, "points", "x,y,z")->required();
  add_model_pose(app, options);
}

void add_probe_options(CLI::App& app, ProbeOptions& options) {
  app.add_flag("--verify", options.verify,
               "compare with brute force; exit with status 6 if they differ")
      ->group(kQuestionGroup);
  add_model_options(app, options.reading, "--scale", "--up", "the model");
  add_allow_empty(app, options.reading);
  add_strict(app, options.reading.strict);
  add_build_options(app, options.build);
}

void check_probe_options(CLI::App& app, ProbeOptions& options, const std::string& rows) {
  options.reading.offers_empty = true;
  check_build(app, options.build);
  const std::array<std::string, 3> inputs{options.model, rows, options.pose.value_or("")};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
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
