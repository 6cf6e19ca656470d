/// \file
/// A file line by line, or in pieces of a few bytes, in bounded memory.
#pragma once

#include "soms/base/limits.h"
#include "soms/io/detail/file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Lines of a file or a pipe; they end with LF, CRLF or CR. A byte order mark is passed.
class LineReader {
 public:
  /// \errors ErrorKind::cannot_open (missing, unreadable, a directory), cancelled.
  explicit LineReader(const std::filesystem::path& path, const Limits& limits = {});

  /// The same of bytes in memory; `name` is used in messages.
  LineReader(std::string name, std::vector<char> bytes);

  /// The next line without its end, valid until the next call; nothing at the end of the file.
  /// \errors ErrorKind::bad_file (a line longer than 1 MiB), cannot_open (reading failed),
  /// cancelled.
  [[nodiscard]] std::optional<std::string_view> next();

  /// True if `next` will not wait: a whole line is at hand, or the end of the file.
  /// \errors As `next`.
  [[nodiscard]] bool ready();

  /// True if the file goes on with `start`, of which nothing is passed. Waits no longer than the
  /// first byte that differs. \errors As `next`.
  [[nodiscard]] bool starts_with(std::string_view start);

  /// The next `count` bytes, whatever they are, valid until the next call; fewer at the end of the
  /// file. \pre `count` is at most 64 KiB. \errors As `next`.
  [[nodiscard]] std::string_view bytes(std::size_t count);

  /// True if `bytes` will not wait. \errors As `next`.
  [[nodiscard]] bool has_bytes(std::size_t count);

  /// Number, from 1, of the line that `next` gave last.
  [[nodiscard]] std::uint64_t number() const { return number_; }

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  [[nodiscard]] bool find_end();
  void fill();

  std::string name_;
  Limits limits_;
  Descriptor file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::size_t looked_at_ = 0;  ///< bytes from `begin_` on that are no end of a line
  std::uint64_t number_ = 0;
  bool after_carriage_return_ = false;
  bool at_end_ = false;  ///< of the file: there is no more than the buffer holds
};

}  // namespace soms::detail
