/// \file
/// The verb `overlap`: which triangles of two models share a point?
#pragma once

#include "soms/query/overlap.h"

#include "apps/cli/verb.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/pairs/traversal_by_name.h"

#include <memory>
#include <string>

namespace soms::command {

/// Options of the verb `overlap`.
struct OverlapVerbOptions : PairOptions {
  OverlapOptions query;
  std::shared_ptr<const TraversalByName> traversal = nullptr;
  bool list_pairs = true;
  bool by_part = false;      ///< lists pairs of parts, not of triangles
  std::string fail_if = {};  ///< "overlap" or "within"; empty: no condition
  double clearance = 0;      ///< with --clearance
};

[[nodiscard]] Action add_overlap(Parser& parser, Shared& shared);
[[nodiscard]] int run_overlap(const OverlapVerbOptions& options, Console& console);

}  // namespace soms::command
