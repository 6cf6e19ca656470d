/// \file
/// Scenes for tests, and what they should report.
#pragma once

#include "soms/base/random.h"
#include "soms/scene/scene.h"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace soms::test {

/// Who is not to be compared with whom, kept beside a scene.
struct Exclusions {
  std::map<MoverId, std::uint32_t> groups;
  std::set<std::pair<MoverId, MoverId>> movers;  ///< the lesser first
  std::set<std::pair<MoverId, EnvironmentId>> parts;

  [[nodiscard]] bool excludes(MoverId a, MoverId b) const;
};

/// The contacts by a scan of all pairs of bodies, each by brute force.
[[nodiscard]] StepReport scan(const Scene& scene, const Exclusions& exclusions = {});

/// A scene of many small bodies within `reach` of the origin.
[[nodiscard]] Scene random_scene(Rng& rng, double reach, std::uint64_t movers, std::uint64_t parts);

}  // namespace soms::test
