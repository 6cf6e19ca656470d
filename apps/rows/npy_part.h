/// \file
/// Some rows of a NumPy array file, without reading those before.
#pragma once

#include "apps/output/temporary_file.h"
#include "apps/rows/shard.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace soms::command {

/// Where the rows of a NumPy array file (.npy) lie.
struct NpyLayout {
  std::uint64_t rows = 0;
  std::uint64_t row_bytes = 0;
  std::uint64_t begin = 0;  ///< of the first row, in bytes
  std::string before_rows;  ///< text of the header up to the number of rows
  std::string after_rows;
};

/// Nothing for what is no such file, or none whose size and header agree: whoever reads it from its
/// beginning says what is wrong with it.
[[nodiscard]] std::optional<NpyLayout> npy_layout(const std::filesystem::path& path);

/// A file of these rows alone. \errors ErrorKind::cannot_open, cannot_write.
[[nodiscard]] TemporaryFile npy_part(const std::filesystem::path& path, const NpyLayout& layout,
                                     const RowRange& rows);

}  // namespace soms::command
