/// \file
/// Bytes made fewer by zlib, as ZIP archives and PNG pictures have them.
#pragma once

#include <string>
#include <string_view>

namespace soms::command {

enum class DeflateForm : unsigned char {
  raw,   ///< as members of ZIP archives
  zlib,  ///< with its head and checksum, as in PNG
};

/// The same bytes for the same input and the same version of zlib.
/// \source RFC 1950, RFC 1951.
[[nodiscard]] std::string deflated(std::string_view bytes, DeflateForm form);

}  // namespace soms::command
