/// \file
/// The verb `convert`: reads any model, writes PLY, 3DS, STL, OFF, OBJ or GLB.
#pragma once

#include "apps/cli/verb.h"
#include "apps/model/models.h"
#include "apps/soms/models/model_output.h"

#include <string>

namespace soms::command {

/// Options of the verb `convert`.
struct ConvertOptions {
  std::string input;
  ModelOptions model;
  ModelOutput output;
};

[[nodiscard]] Action add_convert(Parser& parser, Shared& shared);
[[nodiscard]] int run_convert(const ConvertOptions& options, Console& console);

}  // namespace soms::command
