/// \file
/// The verb `closest`: where is a model nearest to points?
#pragma once

#include "apps/soms/probes/probe_options.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace soms::command {

/// Options of the verb `closest`.
struct ClosestVerbOptions : PointOptions {
  std::uint64_t nearest = 0;     ///< so many triangles for each point; 0: the nearest point
  std::optional<double> radius;  ///< all triangles within it, or the nearest of them
  double at_most = std::numeric_limits<double>::infinity();
  bool with_side = false;  ///< whether each point is inside the model, too
};

[[nodiscard]] Action add_closest(Parser& parser, Shared& shared);
[[nodiscard]] int run_closest(const ClosestVerbOptions& options, Console& console);

}  // namespace soms::command
