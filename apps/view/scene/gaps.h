/// \file
/// Who is near whom in a shown scene without touching, and how near.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/scene/step_report.h"

#include "apps/view/scene/touch.h"

#include <string>
#include <vector>

namespace soms::view {

/// Body `a`, a mover, is within the clearance of body `b`, a part of the city or a mover of greater
/// number, and does not touch it.
struct Gap {
  BodyRef a = {};
  BodyRef b = {};
  TriangleId i = 0;  ///< the least pair of triangles that is as near as the bodies
  TriangleId j = 0;
  Bracket distance = {};
  Vec3 point_a = {};  ///< ends of a shortest segment, in world
  Vec3 point_b = {};

  [[nodiscard]] bool operator==(const Gap&) const = default;
};

/// The gaps of a step, the nearest first; of equal ones that of the lesser bodies.
[[nodiscard]] std::vector<Gap> gaps_of(const StepReport& report);

/// Length of a gap as it is written beside it: four digits and the unit, "0.2345 m".
[[nodiscard]] std::string length_of(const Gap& gap);

}  // namespace soms::view
