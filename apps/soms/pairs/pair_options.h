/// \file
/// Options of every verb that asks something about two models at rows of poses.
#pragma once

#include "soms/tree/build_options.h"

#include "apps/output/output.h"
#include "apps/shards/posed_models.h"

#include <string>

namespace soms::command {

/// Heading of the options that say what the question is.
inline constexpr const char* kQuestionGroup = "Question";

/// Two models, their poses, and where answers go.
using PairOptions = PosedModels;

/// Adds A, B, --pose and --pose-b.
void add_posed_models(Parser& parser, PairOptions& options);

/// Adds --verify.
void add_verify(Parser& parser, PairOptions& options);

/// Adds the options that say how models are read, and those of their trees.
void add_model_reading(Parser& parser, PairOptions& options);

/// Spreads options that hold for both models.
/// \errors As `check_build`.
void settle(const Parser& parser, PairOptions& options);

/// The end of --help: two models, and `line` as a command that asks about them.
[[nodiscard]] std::string example_of_pair(const std::string& line);

/// \errors ErrorKind::usage if standard input is given twice, or as `check_answer_outputs`.
void check_files(const PairOptions& options);

}  // namespace soms::command
