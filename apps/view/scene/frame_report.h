/// \file
/// What a step reports, or a recording holds of a frame, as the viewer shows it.
#pragma once

#include "soms/scene/replay.h"
#include "soms/scene/step_report.h"

#include "apps/view/scene/touch.h"

#include <cstdint>
#include <vector>

namespace soms::view {

/// Contacts and gaps of a recorded frame, as its step reported them.
[[nodiscard]] StepReport report_of(const RecordedFrame& frame);

/// The contacts of a step, sorted.
[[nodiscard]] std::vector<Touch> touches_of(const StepReport& report);

/// Clearance of a recording; 0 for null.
[[nodiscard]] double clearance_of(const Replay* recording);

/// Where mover `k` was; null for no recording, and for a frame or mover that it does not have.
/// \errors As `Replay::frame`.
[[nodiscard]] const Pose* recorded_pose(Replay* recording, std::uint64_t frame, std::uint32_t k);

}  // namespace soms::view
