/// \file
/// What `thesis` says of its tests, for people.
#pragma once

#include "apps/soms/thesis/thesis.h"
#include "apps/soms/thesis/thesis_run.h"

#include <string>
#include <vector>

namespace soms::command {

/// All tests of a run.
struct ThesisReport {
  const ThesisOptions& options;
  std::vector<ThesisResult> results = {};
  std::vector<std::string> remarks = {};  ///< about the models
  std::vector<FrameWarning> warnings = {};
};

/// The build of the trees and the traversal: "rule soms, midpoint thesis, ...".
[[nodiscard]] std::string thesis_options_in_words(const ThesisOptions& options);

/// Boxes of the last level that a tree may have, and leaves of levels above.
struct LevelOfTree {
  int level = 0;  ///< counted from `LevelsOfTree::root`
  std::uint64_t boxes = 0;
  std::uint64_t leaves_above = 0;
};

/// The last level, or the deepest that there is where the tree has fewer levels or no limit.
[[nodiscard]] LevelOfTree last_level(const Tree& tree, const LevelsOfTree& levels);

/// One test: a table of its frames, and what it comes to. Several: a row each.
[[nodiscard]] std::string thesis_text(const ThesisReport& report);

}  // namespace soms::command
