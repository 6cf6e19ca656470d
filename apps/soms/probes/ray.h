/// \file
/// The verb `ray`: what of a model do rays hit, or the segments between two points?
#pragma once

#include "soms/base/vector.h"

#include "apps/soms/probes/probe_options.h"

#include <optional>
#include <string>

namespace soms::command {

/// Options of the verb `ray`.
struct RayVerbOptions : ProbeOptions {
  std::string rays = {};      ///< the file, or
  std::string segments = {};  ///< that of segments
  bool any = false;           ///< only whether there is a hit
  bool all = false;           ///< every place that is hit
  std::optional<TriangleId> skip = std::nullopt;
  bool fail_if_hit = false;
};

[[nodiscard]] Action add_ray(Parser& parser, Shared& shared);
[[nodiscard]] int run_ray(const RayVerbOptions& options, Console& console);

}  // namespace soms::command
