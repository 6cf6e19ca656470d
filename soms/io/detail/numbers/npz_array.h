/// \file
/// An array in a NumPy archive.
#pragma once

#include "soms/io/detail/numbers/line_reader.h"

#include <string_view>

namespace soms::detail {

/// What a ZIP archive begins with: of a NumPy archive as well.
inline constexpr std::string_view kZipMagic = "PK\x03\x04";

/// The array of an archive that holds one, or the one that is named as what its rows are. Arrays
/// must be stored, not compressed, as numpy.savez does it. The checksum of each stored member is
/// compared, and no name may stand twice.
class NpzArray {
 public:
  /// Reads the archive whole. `what` is what the rows are: "points".
  /// \errors ErrorKind::bad_file for what is no such archive, or holds other arrays, which the
  /// error
  ///         names; unsupported for compressed arrays; those of `archive`.
  NpzArray(LineReader& archive, std::string_view what);

  /// The array's own file, from its first byte on.
  [[nodiscard]] LineReader& file() { return file_; }

 private:
  LineReader file_;
};

}  // namespace soms::detail
