/// \file
/// A file whose bytes are seen where the system has them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

namespace soms::detail {

/// Bytes with what keeps them.
struct HeldBytes {
  std::shared_ptr<const void> owner;
  std::span<const std::byte> bytes;
};

/// Maps a regular file, read only. Its pages are read when they are first met, and processes share
/// them. Where the system cannot map it is loaded.
/// \errors ErrorKind::cannot_open.
[[nodiscard]] HeldBytes map_file(const std::filesystem::path& path);

/// Reads a file into memory of the program's own, on large pages where the system has them.
/// \errors As `map_file`.
[[nodiscard]] HeldBytes load_file(const std::filesystem::path& path);

/// The first bytes of a file, as many as it has up to `most`.
/// \errors As `map_file`.
[[nodiscard]] HeldBytes first_bytes(const std::filesystem::path& path, std::size_t most);

}  // namespace soms::detail
