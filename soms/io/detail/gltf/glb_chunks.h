/// \file
/// The chunks of a binary glTF file.
#pragma once

#include "soms/io/detail/left_out.h"
#include "soms/io/detail/source.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace soms::detail {

/// What a binary file holds.
struct GlbChunks {
  std::string_view json;
  std::size_t json_at = 0;
  std::optional<std::string_view> binary;
  LeftOut others;   ///< chunks beside the first two
  LeftOut surplus;  ///< bytes behind the last chunk
};

/// The chunks of the binary glTF that the file has from byte `begin` to `end`.
/// \errors ErrorKind::bad_file (names the byte), unsupported (another version).
/// \pre begin <= end <= source.bytes.size()
[[nodiscard]] GlbChunks glb_chunks(const Source& source, std::size_t begin, std::size_t end);

}  // namespace soms::detail
