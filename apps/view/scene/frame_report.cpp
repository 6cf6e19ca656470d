#include "apps/view/scene/frame_report.h"

#include <algorithm>

namespace soms::view {

StepReport report_of(const RecordedFrame& frame) {
  StepReport report;
  report.environment = frame.environment;
  report.movers = frame.movers;
  report.environment_gaps = frame.environment_gaps;
  report.mover_gaps = frame.mover_gaps;
  report.environment_passages = frame.environment_passages;
  report.mover_passages = frame.mover_passages;
  return report;
}

std::vector<Touch> touches_of(const StepReport& report) {
  std::vector<Touch> touches;
  touches.reserve(report.environment.size() + report.movers.size());
  for (const EnvironmentContact& c : report.environment) {
    touches.push_back({mover(c.mover), city_part(c.part), c.i, c.j});
  }
  for (const MoverContact& c : report.movers) {
    touches.push_back({mover(c.a), mover(c.b), c.i, c.j});
  }
  std::sort(touches.begin(), touches.end());
  return touches;
}

double clearance_of(const Replay* recording) {
  return recording == nullptr ? 0 : recording->head().clearance;
}

const Pose* recorded_pose(Replay* recording, std::uint64_t frame, std::uint32_t k) {
  if (recording == nullptr || frame >= recording->frames()) {
    return nullptr;
  }
  const RecordedFrame& shown = recording->frame(frame);
  return k < shown.poses.size() ? &shown.poses[k] : nullptr;
}

}  // namespace soms::view
