/// \file
/// The gaps of a frame: who is within the clearance of whom without touching.
#pragma once

#include "soms/scene/step_report.h"

#include "apps/view/scene/gap.h"

#include <string>
#include <vector>

namespace soms::view {

/// The gaps of a step, the nearest first; of equal ones that of the lesser bodies. `a` is a mover,
/// `b` a part of the city or a mover of greater number.
[[nodiscard]] std::vector<Gap> gaps_of(const StepReport& report);

/// A gap as it is written beside its line, where lengths are in meters: "0.2345 m".
[[nodiscard]] std::string meters_in_text(const Gap& gap);

}  // namespace soms::view
