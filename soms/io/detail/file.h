/// \file
/// The bytes of a file, read in one go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace soms::detail {

/// Bytes that were read, not cleared before.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

/// Reads a whole file, by read() and not by mapping: a file that shrinks meanwhile gives fewer
/// bytes and no crash. Pipes are read to their end. `most` is the most bytes to read; 0 means any
/// file and 4 GiB of a pipe, which may never end. \errors ErrorKind::cannot_open (missing,
/// unreadable, a directory or device), out_of_memory.
[[nodiscard]] FileBytes read_file(const std::filesystem::path& path, std::uint64_t most);

}  // namespace soms::detail
