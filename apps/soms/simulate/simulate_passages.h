/// \file
/// What movers touch between two frames.
#pragma once

#include "soms/scene/step_report.h"

#include <cstdint>
#include <vector>

namespace soms::command {

/// A mover touches a body of the city, or another mover, on its way to a frame, or is not proved
/// free there.
struct PassageEvent {
  std::uint64_t frame = 0;          ///< the way ends there
  EnvironmentPassage passage = {};  ///< `part` is `Contact::kMover` for another mover
  MoverId other = 0;                ///< number of the other mover (greater than `mover`), or 0
  bool unseen = false;              ///< the two touch in neither of the two frames

  [[nodiscard]] bool between_movers() const;
};

/// Collects passages from frame to frame.
class PassageLog {
 public:
  /// Adds the report of the next frame.
  void add(const StepReport& report, std::uint64_t frame);

  /// By frame; those with the city come first.
  [[nodiscard]] const std::vector<PassageEvent>& events() const { return events_; }

  [[nodiscard]] std::uint64_t between_movers() const;

 private:
  std::vector<PassageEvent> events_;
};

}  // namespace soms::command
