/// \file
/// The gaps of a scene by comparing all pairs of bodies: what a step with a clearance must equal.
#pragma once

#include "soms/scene/scene.h"

#include <functional>
#include <vector>

namespace soms::reference {

/// Which pairs of bodies are compared: all where a function is empty.
struct ComparedPairs {
  std::function<bool(MoverId mover, EnvironmentId part)> environment = {};
  std::function<bool(MoverId a, MoverId b)> movers = {};  ///< `a` is less than `b`
};

/// Calls `environment` or `movers` for each compared pair of bodies: by mover, then part; by a,
/// then b.
void for_each_compared_pair(
    const Scene& scene, const ComparedPairs& compared,
    const std::function<void(MoverId mover, EnvironmentId part)>& environment,
    const std::function<void(MoverId a, MoverId b)>& movers);

/// Gaps as of StepReport.
struct Gaps {
  std::vector<EnvironmentGap> environment;
  std::vector<MoverGap> movers;

  [[nodiscard]] bool operator==(const Gaps&) const = default;
};

/// The pairs of bodies that do not touch and are at most `clearance` apart, without a broad phase:
/// the distance of each pair is queried without a limit and compared with the clearance afterwards.
/// \cost  O(m (n + m)) distances, m movers and n parts.
[[nodiscard]] Gaps gaps(const Scene& scene, double clearance, const ComparedPairs& compared = {});

}  // namespace soms::reference
