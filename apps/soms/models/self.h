/// \file
/// The verb `self`: which triangles of a model cross each other or touch, beyond their corners.
#pragma once

#include "soms/query/self_overlap.h"

#include "apps/cli/verb.h"
#include "apps/model/models.h"
#include "apps/rows/answer_outputs.h"

#include <string>

namespace soms::command {

/// Options of the verb `self`.
struct SelfVerbOptions {
  std::string input;
  ModelOptions model;
  BuildOptions build;
  SelfOverlapOptions question;
  bool fail_if_overlap = false;
  bool verify = false;
  AnswerOutputs outputs;
};

[[nodiscard]] Action add_self(Parser& parser, Shared& shared);
[[nodiscard]] int run_self(const SelfVerbOptions& options, Console& console);

}  // namespace soms::command
