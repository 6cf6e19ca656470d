/// \file
/// Small recordings for tests.
#pragma once

#include "soms/base/random.h"
#include "soms/query/body.h"
#include "soms/scene/recording.h"
#include "soms/scene/replay.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace soms::test {

/// A recording as bytes, with what it should give back.
struct Recorded {
  std::string bytes;
  RecordingHead head;
  std::vector<RecordedFrame> frames;
  RecordingEnd end;
  std::vector<Shape> shapes = {};  ///< of the models, where they were made; body k has model k
};

/// A scene that was stepped: touching bodies with integer corners at random places. With a
/// clearance, gaps as well, and of swept steps passages; all else is then the same.
[[nodiscard]] Recorded record_scene(Rng& rng, std::uint64_t movers, std::uint64_t frames,
                                    RecordingEnding ending = RecordingEnding::complete,
                                    double clearance = 0, bool swept = false);

/// One mover that shifts and now and then touches, in about 2 KB: two chunks of frames.
[[nodiscard]] Recorded record_drive();

/// Two movers, one of which comes nearer to the other and to what stands still, until it touches
/// both; its clearance is 2. In about 4 KB: two chunks of frames, in all but a few of which nothing
/// is near.
[[nodiscard]] Recorded record_approach();

/// A mover that is before a wall, behind it, and before it again, while another crosses its way: a
/// passage of each list, without a contact.
[[nodiscard]] Recorded record_passages();

/// Frames without movers: the smallest recording of its kind.
[[nodiscard]] Recorded record_nothing(std::uint64_t frames);

/// Opens bytes as a recording named "run".
[[nodiscard]] Replay replay_of(const std::string& bytes);

/// `bytes` with the content of the chunk that begins at `begin` changed by `change`, and its
/// checksums made good: what a faulty program would write.
[[nodiscard]] std::string forged(const std::string& bytes, std::size_t begin,
                                 const std::function<void(std::string& content)>& change);

/// Where the chunk behind the head begins.
[[nodiscard]] std::size_t second_chunk(const std::string& bytes);

/// All frames that play.
[[nodiscard]] std::vector<RecordedFrame> frames_of(Replay& replay);

}  // namespace soms::test
