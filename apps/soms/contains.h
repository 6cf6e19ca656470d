/// \file
/// The verb `contains`: which points are inside a model?
#pragma once

#include "soms/tree/build_options.h"

#include "apps/support/models.h"
#include "apps/support/verb.h"

#include <optional>
#include <string>

namespace soms::command {

/// Options of the verb `contains`.
struct ContainsVerbOptions {
  std::string model;
  std::string points;
  std::optional<std::string> pose;  ///< unset: not moved
  ModelOptions reading;
  BuildOptions build;
  bool closed_parts = false;  ///< leave open connected parts out
  bool verify = false;
};

[[nodiscard]] Action add_contains(CLI::App& app, Shared& shared);
[[nodiscard]] int run_contains(const ContainsVerbOptions& options, Console& console);

}  // namespace soms::command
