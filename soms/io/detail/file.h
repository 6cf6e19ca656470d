/// \file
/// The bytes of a file, read in one go.
#pragma once

#include "soms/base/limits.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

namespace soms::detail {

/// A file that is closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}

  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

/// Opens a file or a pipe, no folder; the caller wraps it in a Descriptor. Whoever is to write into
/// a pipe is waited for by `read_some`. A socket is none but one that is open already, as
/// /dev/stdin may be.
/// \errors ErrorKind::cannot_open.
[[nodiscard]] int open_for_reading(const std::filesystem::path& path);

/// Reads between 1 and `wanted` bytes; 0 only at the end. Waits for them as long as no stop is
/// requested. \errors ErrorKind::cannot_open, cancelled.
[[nodiscard]] std::size_t read_some(const std::filesystem::path& path, int fd, char* to,
                                    std::size_t wanted, const Limits& limits);

/// True if `read_some` would answer at once: by bytes, by the end, or by an error.
[[nodiscard]] bool is_readable(int fd);

/// Bytes that were read, not cleared before.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

/// Reads a whole file, by read() and not by mapping: a file that shrinks meanwhile gives fewer
/// bytes and no crash. Pipes are read to their end. `most` is the most bytes to read; 0 means any
/// file and 4 GiB of a pipe, which may never end. \errors ErrorKind::cannot_open (missing,
/// unreadable, a directory or device), out_of_memory, cancelled.
[[nodiscard]] FileBytes read_file(const std::filesystem::path& path, std::uint64_t most,
                                  const Limits& limits = {});

/// A regular file that was opened by its own name and no link's: a link or a pipe that was put
/// there after the name was looked at is refused, and not waited for.
class RegularFile {
 public:
  /// \errors ErrorKind::cannot_open (also a link, a pipe, a folder or a device).
  explicit RegularFile(std::filesystem::path path);

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// The same for all names of one file.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> id() const { return id_; }

  /// Its bytes, no more than it had when it was opened. \errors as of `read_file`.
  [[nodiscard]] FileBytes read() const;

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;
  std::pair<std::uint64_t, std::uint64_t> id_;  ///< device and number
};

}  // namespace soms::detail
