/// \file
/// Small recordings for tests.
#pragma once

#include "soms/base/random.h"
#include "soms/scene/recording.h"
#include "soms/scene/replay.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms::test {

/// A recording as bytes, with what it should give back.
struct Recorded {
  std::string bytes;
  RecordingHead head;
  std::vector<RecordedFrame> frames;
  RecordingEnd end;
};

/// A scene that was stepped: touching bodies with integer corners at random places.
[[nodiscard]] Recorded record_scene(Rng& rng, std::uint64_t movers, std::uint64_t frames,
                                    RecordingEnding ending = RecordingEnding::complete);

/// One mover that shifts and now and then touches, in about 2 KB: two chunks of frames.
[[nodiscard]] Recorded record_drive();

/// Frames without movers: the smallest recording of its kind.
[[nodiscard]] Recorded record_nothing(std::uint64_t frames);

/// Opens bytes as a recording named "run".
[[nodiscard]] Replay replay_of(const std::string& bytes);

/// All frames that play.
[[nodiscard]] std::vector<RecordedFrame> frames_of(Replay& replay);

}  // namespace soms::test
