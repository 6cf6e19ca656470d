/// \file
/// The trees that `soms info` builds of a model: how long they take, and what they are like.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/build_options.h"
#include "soms/tree/statistics.h"

#include "apps/output/json.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

class Console;

/// A tree of the model by one rule.
struct RuleReport {
  std::string_view rule;
  std::uint64_t levels = 0;
  TreeStatistics counts;
  double sah = 0;
  double build_ms = 0;  ///< median
  int build_runs = 0;   ///< of so many builds
};

/// How many builds to time where the first took `first_ms`: those that fit in 100 ms with it, an
/// odd number from 1 to 9, so that the median is one of them.
[[nodiscard]] constexpr int builds_to_time(double first_ms) {
  constexpr double kBudget = 100;
  int runs = 9;
  while (runs > 1 && !(runs * first_ms <= kBudget)) {
    runs -= 2;
  }
  return runs;
}

/// \errors As `build`; ErrorKind::timed_out.
[[nodiscard]] RuleReport measure_tree(const MeshView& mesh, const BuildOptions& options,
                                      const Console& console);

[[nodiscard]] Json to_json(const RuleReport& report);

/// A table of all, for a terminal; empty where there are none.
[[nodiscard]] std::string describe_trees(const std::vector<RuleReport>& trees, int per_leaf);

}  // namespace soms::command
