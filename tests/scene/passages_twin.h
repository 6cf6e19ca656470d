/// \file
/// The passages of a scene by comparing all pairs of bodies: what a swept step must equal.
#pragma once

#include "soms/scene/reference/gaps.h"
#include "soms/scene/scene.h"

#include <map>
#include <vector>

namespace soms::test {

/// Passages as of StepReport.
struct Passages {
  std::vector<EnvironmentPassage> environment;
  std::vector<MoverPassage> movers;

  [[nodiscard]] bool operator==(const Passages&) const = default;
};

/// The pairs of bodies that are not free on the way, without a broad phase: the first contact of
/// each pair is queried. `before` has the poses of the movers that have a way, at its begin.
/// \cost  O(m (n + m)) first contacts, m movers and n parts.
[[nodiscard]] Passages passages(const Scene& scene, const std::map<MoverId, Pose>& before,
                                const reference::ComparedPairs& compared = {});

}  // namespace soms::test
