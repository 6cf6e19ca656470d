/// \file
/// The verb `overlap`: which triangles of two models share a point?
#pragma once

#include "soms/query/overlap.h"

#include "apps/support/models.h"
#include "apps/support/verb.h"

#include <optional>
#include <string>

namespace soms::command {

/// Options of the verb `overlap`.
struct OverlapVerbOptions {
  std::string a;
  std::string b;
  std::optional<std::string> pose_a;  ///< unset: not moved
  std::optional<std::string> pose_b;
  ModelOptions model_a;
  ModelOptions model_b;
  BuildOptions build;
  OverlapOptions query;
  bool list_pairs = true;
  bool fail_if_overlap = false;
  bool verify = false;
  std::string report = {};  ///< empty: none
  std::string csv = {};     ///< empty: none
  bool by_part = false;     ///< lists pairs of parts, not of triangles
};

[[nodiscard]] Action add_overlap(CLI::App& app, Shared& shared);
[[nodiscard]] int run_overlap(const OverlapVerbOptions& options, Console& console);

}  // namespace soms::command
