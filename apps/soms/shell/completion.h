/// \file
/// The verb `completion`: a script that lets a shell complete verbs and options.
#pragma once

#include "apps/cli/verb.h"

namespace soms::command {

/// Shells that completion scripts are written for.
enum class Shell { bash, zsh, fish };

/// Options of the verb `completion`.
struct CompletionOptions {
  Shell shell = Shell::bash;
};

[[nodiscard]] Action add_completion(Parser& parser, Shared& shared);
[[nodiscard]] int run_completion(const CompletionOptions& options, Console& console);

}  // namespace soms::command
