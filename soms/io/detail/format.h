/// \file
/// Which format a file has: recognized by its content, then by its name.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <span>
#include <string_view>

namespace soms::detail {

/// A format that can be read.
struct ReadFormat {
  std::string_view name;       ///< as in messages
  std::string_view extension;  ///< of file names, lower case, with its point
  /// True if the content alone tells that it is this format.
  bool (*recognizes)(std::string_view bytes);
  Mesh (*read)(Source& source);
  bool binary = false;  ///< never text
};

/// Formats that are read here; those of soms-import are not among them.
[[nodiscard]] std::span<const ReadFormat> read_formats();

/// The format of a file.
/// \errors ErrorKind::bad_file (empty, or the name says another format than the content),
/// unsupported (names the formats that are read).
[[nodiscard]] const ReadFormat& identify(const Source& source);

}  // namespace soms::detail
