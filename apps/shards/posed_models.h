/// \file
/// What a verb asks about two models at rows of poses, as far as a share of the rows needs it.
#pragma once

#include "soms/tree/build_options.h"

#include "apps/model/models.h"
#include "apps/rows/answer_outputs.h"
#include "apps/rows/shard.h"

#include <memory>
#include <optional>
#include <string>

namespace soms::command {

class ShardFiles;

/// Two models, their poses, and which rows are answered.
struct PosedModels {
  std::string a;
  std::string b;
  std::optional<std::string> pose_a;  ///< unset: not moved
  std::optional<std::string> pose_b;
  ModelOptions model_a;
  ModelOptions model_b;
  BuildOptions build;
  bool verify = false;
  AnswerOutputs outputs = {};
  std::optional<Shard> shard = {};               ///< of the rows; unset: all
  std::shared_ptr<const ShardFiles> files = {};  ///< of that share, once the verb has begun
};

}  // namespace soms::command
