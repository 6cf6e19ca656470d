/// \file
/// The verb `contains`: which points are inside a model?
#pragma once

#include "apps/soms/probes/probe_options.h"

#include <string>

namespace soms::command {

/// What `contains` answers for.
enum class ContainsBy { model, part, connected };

/// Options of the verb `contains`.
struct ContainsVerbOptions : PointOptions {
  bool closed_parts = false;  ///< leave open connected parts out
  bool winding = false;       ///< decide by the winding number
  double width = 1e-9;        ///< WindingOptions::width
  ContainsBy by = ContainsBy::model;
};

[[nodiscard]] Action add_contains(Parser& parser, Shared& shared);
[[nodiscard]] int run_contains(const ContainsVerbOptions& options, Console& console);

}  // namespace soms::command
