#include "soms/scene/replay.h"

#include "soms/scene/detail/recording_format.h"
#include "soms/scene/detail/recording_reader.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace soms {

namespace {

using detail::ChunkContent;
using detail::ChunkHead;

/// A chunk of whole frames.
struct Chunk {
  std::uint64_t first = 0;
  std::uint64_t begin = 0;  ///< byte of its content
  std::uint64_t length = 0;
  std::uint64_t sum = 0;  ///< of its content
};

std::unique_ptr<std::istream> open(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool there = std::filesystem::exists(status);
  if (there && !std::filesystem::is_regular_file(status)) {
    throw Error(ErrorKind::cannot_open, path.string() + ": not a file", "give a recording");
  }
  auto in = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*in) {
    throw Error(ErrorKind::cannot_open,
                path.string() + (there ? ": cannot be read" : ": there is no such file"),
                "check the name");
  }
  return in;
}

/// Reads the content of a chunk by `read`. That a byte was altered says more than what it broke.
/// \returns the content's checksum.
template <class Read>
std::uint64_t read_content(detail::RecordingBytes& bytes, const ChunkHead& head, const Read& read) {
  const std::uint64_t begin = bytes.position();
  ChunkContent content(bytes, head.length);
  std::optional<Error> wrong;
  try {
    read(content);
    if (content.left() != 0) {
      wrong = content.fault("a chunk is too long for its content");
    }
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      throw;
    }
    wrong = error;
  }
  if (!content.is_unaltered()) {
    throw bytes.fault(begin, "the chunk that begins here is corrupt");
  }
  if (wrong) {
    throw Error(*wrong);
  }
  return content.sum();
}

}  // namespace

struct Replay::State {
  detail::RecordingBytes bytes;
  RecordingHead head{};
  std::vector<Chunk> chunks{};
  std::uint64_t frames = 0;
  std::optional<RecordingEnd> end{};
  std::optional<Error> fault{};
  RecordedFrame frame{};
  std::optional<ChunkContent> playing{};
  std::uint64_t next = 0;  ///< frame that `playing` stands before

  void open(const Limits& limits) {
    read_the_head(detail::read_file_head(bytes));
    try {
      while (!end) {
        check(limits);
        read_chunk();
        if (limits.progress) {
          limits.progress(static_cast<double>(bytes.position()) /
                          static_cast<double>(bytes.size()));
        }
      }
      if (bytes.position() != bytes.size()) {
        end.reset();
        throw bytes.fault(bytes.position(), "there are bytes after the end of the recording");
      }
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) {
        throw;
      }
      end.reset();
      fault = error;
    }
  }

  void read_the_head(std::uint32_t version) {
    const std::uint64_t begin = bytes.position();
    const ChunkHead chunk = detail::read_chunk_head(bytes);
    if (!chunk.is(detail::kHeadTag) || chunk.frames != 0 || chunk.first != 0) {
      throw bytes.fault(begin, "the recording does not begin with its head");
    }
    static_cast<void>(read_content(
        bytes, chunk, [&](ChunkContent& content) { head = detail::read_head(content, version); }));
  }

  /// Frames, or the end.
  void read_chunk() {
    const std::uint64_t begin = bytes.position();
    const ChunkHead chunk = detail::read_chunk_head(bytes);
    if (chunk.first != frames) {
      throw bytes.fault(begin, "frame " + std::to_string(frames) + " is missing");
    }
    if (chunk.is(detail::kFramesTag) && chunk.frames > 0) {
      read_frames(chunk);
    } else if (chunk.is(detail::kEndTag) && chunk.frames == 0) {
      RecordingEnd said;
      static_cast<void>(read_content(
          bytes, chunk, [&](ChunkContent& content) { said = detail::read_end(content, frames); }));
      seen.ending = said.ending;
      seen.frames = frames;
      seen.hash = hash.value();
      if (said != seen) {
        throw bytes.fault(begin,
                          "the number of contacts at the end differs from that of the frames");
      }
      end = said;
    } else {
      throw bytes.fault(begin, "an unknown chunk");
    }
  }

  void read_frames(const ChunkHead& chunk) {
    Chunk place{frames, bytes.position(), chunk.length};
    RecordingEnd sum = seen;
    Fnv1a running = hash;
    place.sum = read_content(bytes, chunk, [&](ChunkContent& content) {
      start();
      for (std::uint32_t k = 0; k < chunk.frames; ++k) {
        read_frame(content, head, frame);
        if (frames + k == 0 &&
            !(frame.environment_passages.empty() && frame.mover_passages.empty())) {
          throw content.fault("passages on the way to the first frame, which has none");
        }
        sum.environment_contacts += frame.environment.size();
        sum.mover_contacts += frame.movers.size();
        running.add(hash_of_contacts());
      }
    });
    seen = sum;
    hash = running;
    chunks.push_back(place);
    frames += chunk.frames;
  }

  /// Goes to the first frame of a chunk, which must be as it was when the file was opened.
  void enter(const Chunk& chunk) {
    playing.reset();
    bytes.seek(chunk.begin);
    ChunkContent again(bytes, chunk.length);
    if (!again.is_unaltered() || again.sum() != chunk.sum) {
      throw Error(ErrorKind::bad_file,
                  bytes.fault(chunk.begin, "the file was changed since it was opened").place(),
                  "open it again");
    }
    bytes.seek(chunk.begin);
    playing.emplace(bytes, chunk.length);
    start();
    next = chunk.first;
  }

  /// Before the first frame of a chunk.
  void start() { frame.poses.assign(head.movers.size(), Pose{}); }

  /// As the step's report would tell it.
  [[nodiscard]] std::uint64_t hash_of_contacts() {
    StepReport report;
    report.environment.swap(frame.environment);
    report.movers.swap(frame.movers);
    const std::uint64_t value = report.hash();
    report.environment.swap(frame.environment);
    report.movers.swap(frame.movers);
    return value;
  }

  RecordingEnd seen{};  ///< contacts counted while opening
  Fnv1a hash{};
};

Replay::Replay(const std::filesystem::path& path, const Limits& limits)
    : Replay(open(path), path.string(), limits) {
}

Replay::Replay(std::unique_ptr<std::istream> bytes, std::string name, const Limits& limits)
    : state_(new State{.bytes = {std::move(bytes), std::move(name)}}) {
  state_->open(limits);
}

Replay::~Replay() = default;
Replay::Replay(Replay&&) noexcept = default;
Replay& Replay::operator=(Replay&&) noexcept = default;

const RecordingHead& Replay::head() const {
  return state_->head;
}

std::uint64_t Replay::frames() const {
  return state_->frames;
}

const std::optional<RecordingEnd>& Replay::end() const {
  return state_->end;
}

const std::optional<Error>& Replay::fault() const {
  return state_->fault;
}

const RecordedFrame& Replay::frame(std::uint64_t i) {
  State& state = *state_;
  if (i >= state.frames) {
    throw Error(
        ErrorKind::usage, "frame " + std::to_string(i) + " of " + std::to_string(state.frames),
        state.frames == 0 ? "the recording holds none"
                          : "frames are numbered from 0 to " + std::to_string(state.frames - 1));
  }
  const auto behind =
      std::upper_bound(state.chunks.begin(), state.chunks.end(), i,
                       [](std::uint64_t frame, const Chunk& chunk) { return frame < chunk.first; });
  const Chunk& chunk = *(behind - 1);
  if (state.playing && state.next == i + 1) {
    return state.frame;
  }
  if (!state.playing || state.next > i || state.next <= chunk.first) {
    state.enter(chunk);
  }
  try {
    while (state.next <= i) {
      read_frame(*state.playing, state.head, state.frame);
      ++state.next;
    }
  } catch (...) {
    state.playing.reset();
    throw;
  }
  return state.frame;
}

bool is_recording(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return false;
  }
  std::ifstream in(path, std::ios::binary);
  std::array<char, detail::kRecordingMagic.size()> begin{};
  return in.read(begin.data(), begin.size()) &&
         std::string_view(begin.data(), begin.size()) == detail::kRecordingMagic;
}

}  // namespace soms
