#include "apps/soms/simulate/simulate_passages.h"

#include "soms/scene/passages.h"

#include "apps/soms/simulate/simulate_contacts.h"

#include <algorithm>

namespace soms::command {

bool PassageEvent::between_movers() const {
  return passage.part == Contact::kMover;
}

void PassageLog::add(const StepReport& report, std::uint64_t frame) {
  for (const EnvironmentPassage& passage : report.environment_passages) {
    events_.push_back({frame, passage, 0, is_between_steps(passage, report.environment)});
  }
  for (const MoverPassage& passage : report.mover_passages) {
    events_.push_back({frame,
                       {passage.a, Contact::kMover, passage.i, passage.j, passage.verdict,
                        passage.t, passage.point},
                       passage.b,
                       is_between_steps(passage, report.movers)});
  }
}

std::uint64_t PassageLog::between_movers() const {
  return static_cast<std::uint64_t>(
      std::count_if(events_.begin(), events_.end(),
                    [](const PassageEvent& event) { return event.between_movers(); }));
}

}  // namespace soms::command
