/// \file
/// `soms thesis`: the orientation tests and the drive of the thesis, frame by frame, in one
/// command.
#pragma once

#include "soms/thesis/traversal_options.h"
#include "soms/tree/build_options.h"

#include "apps/cli/verb.h"
#include "apps/model/models.h"

#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

inline constexpr std::string_view kDriveTest = "drive";
inline constexpr std::string_view kAllTests = "all";

/// What moves past what, on which trees, and what is left of it.
struct ThesisOptions {
  std::string a = {};       ///< stands still; empty: the models of the thesis
  std::string b = {};       ///< moves; empty: the same as A
  std::string models = {};  ///< folder of the thesis' models
  std::string test = {};    ///< name of a test, or `kAllTests`; empty: the four of the thesis
  ModelOptions model_a = {};
  ModelOptions model_b = {};
  BuildOptions build = thesis_options(Rule::soms);
  bool levels_are_given = false;  ///< else a scene that is driven through has 13
  TraversalOptions traversal{.traversal = Traversal::e_node};
  int repetitions = 5;
  bool all_frames = false;  ///< list the frames in which the roots are apart, too
  bool view = false;
  std::string picture = {};  ///< folder of pictures
  std::string csv = {};
  std::vector<std::string> outputs = {};
};

/// Runs the tests and reports them; returns the exit status.
[[nodiscard]] int run_thesis(const ThesisOptions& options, Console& console);

}  // namespace soms::command
