/// \file
/// Nearness over frames: who comes within the clearance of whom, from when to when, and how near.
#pragma once

#include "soms/base/bracket.h"
#include "soms/scene/scene.h"

#include "apps/soms/simulate/simulate_contacts.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::command {

/// A mover is within the clearance of a body of the city, or of another mover, in each frame from
/// `begin` to `end`; bodies that touch have distance 0.
struct NearEvent {
  MoverId mover = 0;
  EnvironmentId part = 0;   ///< body of the city; `Contact::kMover` for another mover
  std::uint32_t other = 0;  ///< number of the other mover (greater than `mover`), or 0
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  std::uint64_t nearest = 0;  ///< the first frame of the least distance
  Bracket distance = {};      ///< in that frame; [0, 0] where the two touch
  TriangleId i = 0;           ///< triangle of the mover, then
  TriangleId j = 0;           ///< triangle of the other
  Vec3 point_a = {};          ///< ends of a shortest segment, in world; none where the two touch
  Vec3 point_b = {};

  [[nodiscard]] bool between_movers() const { return part == Contact::kMover; }

  [[nodiscard]] bool touches() const { return distance.upper == 0; }
};

/// Follows nearness from frame to frame.
class NearLog {
 public:
  /// Adds the report of the next frame, a step with a clearance.
  void add(const StepReport& report, std::uint64_t frame);

  /// Ends what still lasts.
  void finish();

  /// All events, by begin, then mover, then the other; complete after `finish`.
  [[nodiscard]] const std::vector<NearEvent>& events() const { return events_; }

  [[nodiscard]] std::uint64_t between_movers() const;

  /// Events in which the two never touch.
  [[nodiscard]] std::uint64_t without_touch() const;

  /// Numbers of the events that are the nearest of their two bodies without a touch; the nearest
  /// first.
  [[nodiscard]] std::vector<std::size_t> nearest_of_pairs() const;

  /// Numbers of the `n` events of least distance among those without a touch; of equal ones the
  /// first.
  [[nodiscard]] std::vector<std::size_t> nearest(std::size_t n) const;

 private:
  void follow();

  std::vector<NearEvent> events_;
  std::vector<NearEvent> lasting_;  ///< of the frame before, sorted
  std::vector<NearEvent> now_;      ///< scratch
};

}  // namespace soms::command
