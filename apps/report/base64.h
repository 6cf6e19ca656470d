/// \file
/// Numbers as base64, piece by piece, so that a large block never lies in memory twice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

namespace soms::report {

/// Writes numbers as little-endian bytes in base64 (RFC 4648, with padding) to a stream.
class Base64Writer {
 public:
  explicit Base64Writer(std::ostream& out) : out_(out) {}

  void put(std::uint8_t byte);
  void put(std::uint32_t value);
  void put(float value);
  void put(double value);

  /// Writes what is held back and the padding. Nothing may be put afterwards.
  void finish();

  /// Bytes put so far, before they became base64.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  void write_group();
  void flush();

  std::ostream& out_;
  std::array<unsigned char, 3> group_{};
  std::size_t held_ = 0;
  std::string text_;
  std::uint64_t bytes_ = 0;
};

}  // namespace soms::report
