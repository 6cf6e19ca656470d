/// \file
/// Bytes made fewer by zlib, as ZIP archives and PNG pictures have them.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace soms::command {

enum class DeflateForm : unsigned char {
  raw,   ///< as members of ZIP archives
  zlib,  ///< with its head and checksum, as in PNG
};

/// Packs bytes piece by piece. The same bytes for the same input and the same version of zlib.
/// \errors ErrorKind::cannot_write where zlib has no memory.
/// \source RFC 1950, RFC 1951.
class Deflater {
 public:
  explicit Deflater(DeflateForm form);

  void add(std::string_view bytes);

  /// All packed bytes. \pre The last call.
  [[nodiscard]] std::string finish();

 private:
  struct Stream;

  void run(std::string_view bytes, int flush);

  std::unique_ptr<Stream, void (*)(Stream*)> stream_;
  std::string packed_;
};

/// The same of bytes that are all there.
[[nodiscard]] std::string deflated(std::string_view bytes, DeflateForm form);

}  // namespace soms::command
