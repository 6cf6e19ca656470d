/// \file
/// The verb `motion`: when does a model on its way first touch another?
#pragma once

#include "soms/base/vector.h"

#include "apps/cli/verb.h"
#include "apps/soms/pairs/pair_options.h"

#include <optional>
#include <string>

namespace soms::command {

/// Options of the verb `motion`.
struct MotionVerbOptions : PairOptions {
  std::optional<std::string> from = {};  ///< unset: A is where its file has it
  std::optional<std::string> to = {};    ///< one of these three is given
  std::optional<Vec3> by = {};
  std::optional<std::string> path = {};
  std::optional<Vec3> pivot = {};
  std::optional<std::string> to_b = {};  ///< B moves from `pose_b` to this meanwhile
  double clearance = 0;
  bool parting = false;
  bool fail_if_contact = false;
};

[[nodiscard]] Action add_motion(Parser& parser, Shared& shared);
[[nodiscard]] int run_motion(const MotionVerbOptions& options, Console& console);

}  // namespace soms::command
