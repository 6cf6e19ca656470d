/// \file
/// The frames of a simulation, and what is remembered of them.
#pragma once

#include "soms/scene/contact_spans.h"
#include "soms/scene/scene.h"

#include "apps/cli/console.h"
#include "apps/model/frame_warnings.h"
#include "apps/soms/simulate/simulate.h"
#include "apps/soms/simulate/simulate_contacts.h"
#include "apps/soms/simulate/simulate_near.h"
#include "apps/soms/simulate/simulate_passages.h"
#include "apps/soms/simulate/simulate_record.h"
#include "apps/soms/simulate/simulate_verify.h"
#include "apps/soms/simulate/simulate_verify_near.h"
#include "apps/soms/simulate/simulate_verify_passages.h"
#include "apps/world/world.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace soms::command {

/// A place on the ground plan.
struct Place {
  float x = 0;
  float y = 0;
};

/// How a simulation ended.
enum class Ending { whole, timed_out, interrupted };

/// What a simulation found.
struct Outcome {
  std::uint64_t frames = 0;          ///< done
  std::vector<float> frame_seconds;  ///< poses, broad phase, narrow phase and report of each frame
  std::uint64_t queries = 0;
  Cost cost;
  std::uint64_t hash = 0;  ///< of all frames' reports, in order
  ContactLog contacts;
  ContactSpans events;  ///< of a mover and a part of the city, or another mover
  NearLog near;         ///< filled with a clearance alone
  PassageLog passages;  ///< filled by swept steps alone
  std::optional<Verified> verified = std::nullopt;
  std::optional<VerifiedGaps> verified_gaps = std::nullopt;
  std::optional<VerifiedPassages> verified_passages = std::nullopt;
  std::vector<std::vector<Place>> tracks;  ///< where each mover was, at some hundred frames
  Ending ending = Ending::whole;
  BoxWatch boxes;  ///< of movers and the city, until one is near
  /// Of the processors, that other programs used meanwhile, 0 to 1; none of a short run.
  std::optional<double> share_of_others = std::nullopt;

  /// A verification found a difference.
  [[nodiscard]] bool is_wrong() const;

  [[nodiscard]] double median_fps() const;
  [[nodiscard]] double worst_fps() const;
  [[nodiscard]] double queries_a_second() const;
};

/// Runs the frames; Ctrl-C and --timeout end it with the frames done so far. `recorder` may be
/// null.
[[nodiscard]] Outcome run_frames(const World& world, const SimulateOptions& options,
                                 Console& console, Recorder* recorder);

}  // namespace soms::command
