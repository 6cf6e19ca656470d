// A recording of any bytes, as they are and with its checksums mended: typed errors, or frames that
// are the same in any order, and the same when they are recorded again.
#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/scene/recording.h"
#include "soms/scene/replay.h"

#include "tests/fuzz/require.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms {
namespace {

using fuzz::require;

std::uint64_t sum_of(std::string_view bytes) {
  Fnv1a hash;
  for (const char c : bytes) {
    hash.add_byte(static_cast<std::uint8_t>(c));
  }
  return hash.value();
}

void put(std::string& bytes, std::size_t at, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes[at + i] = static_cast<char>(value >> (8 * i) & 0xff);
  }
}

std::uint64_t get(const std::string& bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    value |= std::uint64_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  }
  return value;
}

/// Sums of the file's head and of its chunks, as docs/recording.md has them. Without it no changed
/// byte would pass the first check.
std::string mended(std::string bytes) {
  if (bytes.size() < 16) {
    return bytes;
  }
  const std::string_view view = bytes;
  put(bytes, 12, sum_of(view.substr(0, 12)), 4);
  for (std::size_t chunk = 16; bytes.size() - chunk >= 40;) {
    put(bytes, chunk + 24, sum_of(view.substr(chunk, 24)), 8);
    const std::uint64_t length = get(bytes, chunk + 16);
    if (length > bytes.size() - chunk - 40) {
      break;
    }
    const std::size_t content = chunk + 32;
    put(bytes, content + length, sum_of(view.substr(content, length)), 8);
    chunk = content + length + 8;
  }
  return bytes;
}

std::optional<Replay> open(const std::string& bytes) {
  try {
    return Replay(std::make_unique<std::istringstream>(bytes), "run");
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::bad_file || error.kind() == ErrorKind::unsupported,
            "the kind of a recording's error");
    return std::nullopt;
  }
}

std::vector<RecordedFrame> frames_of(Replay& replay) {
  std::vector<RecordedFrame> frames;
  for (std::uint64_t i = 0; i < replay.frames(); ++i) {
    frames.push_back(replay.frame(i));
    for (const Pose& pose : frames.back().poses) {
      check(pose);
    }
  }
  return frames;
}

void check_recorded_again(const Replay& replay, const std::vector<RecordedFrame>& frames) {
  std::ostringstream out;
  RecordingWriter writer(out, replay.head());
  for (const RecordedFrame& frame : frames) {
    StepReport report;
    report.environment = frame.environment;
    report.movers = frame.movers;
    report.clearance = replay.head().clearance;
    report.environment_gaps = frame.environment_gaps;
    report.mover_gaps = frame.mover_gaps;
    report.swept = replay.head().swept;
    report.environment_passages = frame.environment_passages;
    report.mover_passages = frame.mover_passages;
    writer.add(frame.poses, report);
  }
  writer.finish(replay.end() ? replay.end()->ending : RecordingEnding::interrupted);
  std::optional<Replay> again = open(out.str());
  require(again && again->head() == replay.head(), "a head that was recorded again");
  require(!again->fault() && frames_of(*again) == frames, "frames that were recorded again");
  require(!replay.end() || again->end() == replay.end(), "an end that was recorded again");
}

void check_input(const std::string& bytes) {
  std::optional<Replay> replay = open(bytes);
  if (!replay) {
    return;
  }
  require(replay->end().has_value() != replay->fault().has_value(), "an end or a fault");
  const std::vector<RecordedFrame> frames = frames_of(*replay);
  for (std::uint64_t i = replay->frames(); i-- > 0;) {
    require(replay->frame(i) == frames[i], "frames backwards");
  }
  check_recorded_again(*replay, frames);
}

}  // namespace
}  // namespace soms

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  soms::check_input(bytes);
  soms::check_input(soms::mended(bytes));
  return 0;
}
