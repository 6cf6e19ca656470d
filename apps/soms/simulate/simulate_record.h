/// \file
/// `simulate --record`: what happens in each frame, written as it happens.
#pragma once

#include "soms/scene/recording.h"

#include "apps/output/output.h"
#include "apps/world/world.h"

#include <cstdint>
#include <span>

namespace soms::command {

/// A recording that appears whole, with its end, or not at all.
class Recorder {
 public:
  /// `clearance`: of the steps, meters; 0: none. `swept`: passages are recorded.
  /// \errors ErrorKind::cannot_write, here and below.
  Recorder(OutputFile& file, const World& world, std::uint64_t frames, double clearance,
           bool swept);

  void add(std::span<const Pose> poses, const StepReport& report);

  void finish(RecordingEnding ending);

 private:
  template <class Write>
  void write(const Write& write);

  OutputFile& file_;
  RecordingWriter writer_;
};

}  // namespace soms::command
