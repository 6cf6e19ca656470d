/// \file
/// A recording's bytes, chunk by chunk: nothing is believed before it was compared with what is
/// there.
#pragma once

#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/scene/detail/recording_format.h"
#include "soms/scene/recording.h"

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

namespace soms::detail {

/// A stream of known size that knows where it is.
class RecordingBytes {
 public:
  RecordingBytes(std::unique_ptr<std::istream> in, std::string name);

  [[nodiscard]] std::uint64_t size() const { return size_; }

  [[nodiscard]] std::uint64_t position() const { return position_; }

  void seek(std::uint64_t position);

  /// Reads exactly `count` bytes. \errors ErrorKind::bad_file where there are fewer.
  void read(char* to, std::size_t count);

  /// The error of a fault at a byte.
  [[nodiscard]] Error fault(std::uint64_t byte, const std::string& what) const;

  /// The error of a file that ends too early.
  [[nodiscard]] Error cut() const;

 private:
  std::unique_ptr<std::istream> in_;
  std::string name_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
};

/// The content of one chunk, read piece by piece. Counts are compared with the bytes that are left
/// before memory is taken for them.
class ChunkContent {
 public:
  /// The stream stands at the first byte of the content.
  ChunkContent(RecordingBytes& bytes, std::uint64_t length);

  /// The next unsigned number.
  template <class T>
  [[nodiscard]] T number() {
    return get<T>(take(sizeof(T)));
  }

  [[nodiscard]] double real() { return bit_cast<double>(number<std::uint64_t>()); }

  [[nodiscard]] std::string text();

  /// A number of things of at least `each` bytes, of type T; refused if they cannot all be there.
  template <class T>
  [[nodiscard]] T count(std::size_t each) {
    const T number_of = number<T>();
    if (number_of > left() / each) {
      throw fault(std::to_string(number_of) + " entries in " + std::to_string(left()) + " bytes");
    }
    return number_of;
  }

  /// Bytes that were not taken yet.
  [[nodiscard]] std::uint64_t left() const { return unread_ + (end_ - at_); }

  [[nodiscard]] Error fault(const std::string& what) const;

  /// Passes over the rest; true if the content is as it was written.
  [[nodiscard]] bool is_unaltered();

  /// Checksum of what was read.
  [[nodiscard]] std::uint64_t sum() const { return hash_.value(); }

 private:
  [[nodiscard]] const char* take(std::size_t count);
  void refill();

  RecordingBytes* bytes_;
  std::uint64_t unread_;  ///< bytes of the content that are not in the buffer
  std::vector<char> buffer_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  Fnv1a hash_;
};

/// Throws for a pose that no body of a scene can have: of the writer and the reader alike.
/// \errors As `check(Pose)`; ErrorKind::out_of_range for a shift beyond 2^300.
void check_recordable(const Pose& pose);

/// Throws for a pose that was read and that no body of a scene can have.
/// \errors ErrorKind::bad_file, unsupported.
void check_pose(const ChunkContent& content, const Pose& pose);

/// A value of an enumeration, up to `last`. \errors ErrorKind::bad_file for another one.
template <class T>
[[nodiscard]] T read_choice(ChunkContent& content, T last, const char* what) {
  const auto value = content.number<std::uint8_t>();
  if (value > static_cast<std::uint8_t>(last)) {
    throw content.fault("an unknown " + std::string(what));
  }
  return static_cast<T>(value);
}

/// The first bytes of a file; returns its version. \errors ErrorKind::bad_file, unsupported.
[[nodiscard]] std::uint32_t read_file_head(RecordingBytes& bytes);

/// What the next chunk says of itself, compared with what is left of the file.
/// \errors ErrorKind::bad_file.
[[nodiscard]] ChunkHead read_chunk_head(RecordingBytes& bytes);

/// \errors ErrorKind::bad_file, here and below.
[[nodiscard]] RecordingHead read_head(ChunkContent& content, std::uint32_t version);

/// The next frame over the one before, which must be identities at the start of a chunk.
void read_frame(ChunkContent& content, const RecordingHead& head, RecordedFrame& frame);

[[nodiscard]] RecordingEnd read_end(ChunkContent& content, std::uint64_t frames);

}  // namespace soms::detail
