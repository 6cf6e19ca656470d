/// \file
/// A text file line by line, in bounded memory.
#pragma once

#include "soms/base/parallel.h"
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
  explicit LineReader(const std::filesystem::path& path, const Parallel& parallel = {});

  /// The next line without its end, valid until the next call; nothing at the end of the file.
  /// \errors ErrorKind::bad_file (a line longer than 1 MiB), cannot_open (reading failed),
  /// cancelled.
  [[nodiscard]] std::optional<std::string_view> next();

  /// Number, from 1, of the line that `next` gave last.
  [[nodiscard]] std::uint64_t number() const { return number_; }

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  [[nodiscard]] bool fill();

  std::string name_;
  Parallel parallel_;
  Descriptor file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint64_t number_ = 0;
  bool after_carriage_return_ = false;
};

}  // namespace soms::detail
