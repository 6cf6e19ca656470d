/// \file
/// The verb `robot`: which links of a robot touch each other, or its cell, in given states.
#pragma once

#include "apps/cli/verb.h"
#include "apps/rows/answer_outputs.h"
#include "apps/soms/robot/robot_models.h"

#include <limits>
#include <string>

namespace soms::command {

/// Options of the verb `robot`.
struct RobotVerbOptions : RobotModelsOptions {
  std::string states;        ///< file; empty: random ones
  std::uint64_t random = 0;  ///< number of random states
  std::uint64_t seed = 1;    ///< of these
  std::string home;          ///< "zero" or the name of a state; empty: a header names all
  bool any = false;          ///< stop at the first contact of a state
  bool distance = false;
  double at_most = std::numeric_limits<double>::infinity();
  bool path = false;  ///< states follow each other
  bool fail_if_contact = false;
  bool verify = false;
  AnswerOutputs outputs = {};
};

[[nodiscard]] Action add_robot(Parser& parser, Shared& shared);
[[nodiscard]] int run_robot(const RobotVerbOptions& options, Console& console);

}  // namespace soms::command
