/// \file
/// The verb `contains`: which points are inside a model?
#pragma once

#include "apps/soms/probe_options.h"

namespace soms::command {

/// Options of the verb `contains`.
struct ContainsVerbOptions : PointOptions {
  bool closed_parts = false;  ///< leave open connected parts out
};

[[nodiscard]] Action add_contains(CLI::App& app, Shared& shared);
[[nodiscard]] int run_contains(const ContainsVerbOptions& options, Console& console);

}  // namespace soms::command
