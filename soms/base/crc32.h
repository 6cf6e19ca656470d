/// \file
/// The checksum of ZIP archives and PNG pictures.
#pragma once

#include <cstdint>
#include <string_view>

namespace soms {

/// CRC-32 of bytes that come in pieces.
/// \source PKWARE, APPNOTE.TXT, section 4.4.7; ISO 3309, with the polynomial reflected.
class Crc32 {
 public:
  void add(std::string_view bytes);

  [[nodiscard]] std::uint32_t value() const { return ~state_; }

  /// The same bytes so far.
  [[nodiscard]] bool operator==(const Crc32&) const = default;

 private:
  std::uint32_t state_ = 0xffffffffU;
};

}  // namespace soms
