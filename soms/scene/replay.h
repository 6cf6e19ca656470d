/// \file
/// Reading a recording: any frame at any time, and of a damaged file all that is whole.
#pragma once

#include "soms/base/error.h"
#include "soms/base/limits.h"
#include "soms/scene/recording.h"

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace soms {

/// A recording that is open for playing. Opening reads the file once, in bounded memory: every
/// checksum, pose and number is checked, and an index of chunks is built. Where the file is cut off
/// or altered, the frames before that place play, and `fault` tells kind, byte and remedy.
/// \threads One caller at a time.
class Replay {
 public:
  /// \errors ErrorKind::cannot_open; bad_file where not even the head is whole, or the file is no
  ///         recording; unsupported for a version of the future; cancelled.
  explicit Replay(const std::filesystem::path& path, const Limits& limits = {});

  /// Reads from `bytes`, which must be able to seek; `name` stands for it in errors.
  Replay(std::unique_ptr<std::istream> bytes, std::string name, const Limits& limits = {});
  ~Replay();
  Replay(Replay&&) noexcept;
  Replay& operator=(Replay&&) noexcept;

  [[nodiscard]] const RecordingHead& head() const;

  /// Number of whole frames.
  [[nodiscard]] std::uint64_t frames() const;

  /// The end that the recording states; nothing where there is a fault.
  [[nodiscard]] const std::optional<RecordingEnd>& end() const;

  /// Why the recording does not go on after `frames()`; nothing where it is whole.
  [[nodiscard]] const std::optional<Error>& fault() const;

  /// Frame `i`; the reference lasts until the next call.
  /// \errors  ErrorKind::usage unless `i` is less than `frames()`; bad_file if the chunk of frame
  ///          `i` was changed since the file was opened.
  /// \cost    The next frame: linear in movers, contacts and gaps. Any other, and the first of a
  /// chunk:
  ///          the chunk's checksum, and up to 64 frames are read.
  [[nodiscard]] const RecordedFrame& frame(std::uint64_t i);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// True if a file can be read and begins as a recording does.
[[nodiscard]] bool is_recording(const std::filesystem::path& path);

}  // namespace soms
