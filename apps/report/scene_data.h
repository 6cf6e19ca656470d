/// \file
/// A scene as blocks of data in an HTML page.
#pragma once

#include "apps/report/scene.h"

#include <cstdint>
#include <functional>
#include <ostream>

namespace soms::report {

/// What of a scene found room in the page.
struct Shown {
  std::uint64_t triangles = 0;
  std::uint64_t triangles_in_all = 0;
  std::uint64_t bodies = 0;
  std::uint64_t bodies_in_all = 0;
  std::uint64_t rows = 0;  ///< of pairs of parts or bodies: always all
  std::uint64_t contacts = 0;
  std::uint64_t contacts_in_all = 0;
  std::uint64_t gaps = 0;
  std::uint64_t gaps_in_all = 0;
  std::uint64_t steps = 0;
  std::uint64_t steps_in_all = 0;
  bool is_live = false;  ///< the page holds what it takes to answer again

  [[nodiscard]] bool operator==(const Shown&) const = default;
};

/// Writes script elements that hold the scene: one of JSON, "soms-scene", schema soms.scene/3, and
/// one of base64 for each model, for the poses, the rows, their curves, the contacts and the gaps;
/// last, where there is room, the models and poses as they are (live_data.h).
/// `script`, where it is given, writes the page's script after all that a first picture needs, and
/// before large models. Lengths are relative to an origin near the scene; docs/report.md describes
/// them. \errors Those of `scene.pose`.
Shown write_scene(std::ostream& out, const Scene& scene, const SceneLimits& limits = {},
                  const std::function<void()>& script = {});

}  // namespace soms::report
