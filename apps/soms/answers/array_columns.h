/// \file
/// Lists of any length in a file of NumPy arrays: a list of each row's hits is kept as its parts,
/// and row i has the hits from offsets[i] to before offsets[i + 1].
#pragma once

#include "soms/base/words.h"
#include "soms/geometry/mesh.h"

#include "apps/output/npz_file.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace soms::command {

/// Where the lists of rows begin.
class OffsetColumn {
 public:
  void begin(NpzFile& file, std::string name) {
    column_ = &file.column(std::move(name), NpzColumn::Kind::count);
    column_->add(end_);
  }

  /// The list of the next row has so many entries.
  void add(std::size_t entries) {
    end_ += static_cast<std::int64_t>(entries);
    column_->add(end_);
  }

 private:
  NpzColumn* column_ = nullptr;
  std::int64_t end_ = 0;
};

/// Adds a word to a column of `NpzFile::names`.
template <Worded Enum>
void add_code(NpzColumn& column, Enum value) {
  column.add(static_cast<std::uint8_t>(value));
}

/// The number of a part, or -1 for triangles that are in none.
[[nodiscard]] inline std::int64_t number_of_part(std::uint32_t part) {
  return part == Part::kNoParent ? -1 : std::int64_t{part};
}

}  // namespace soms::command
