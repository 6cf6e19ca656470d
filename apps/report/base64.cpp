#include "apps/report/base64.h"

#include <bit>

namespace soms::report {

namespace {

constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kPiece = std::size_t{1} << 16;  // characters handed on at once

}  // namespace

void Base64Writer::put(std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    put(static_cast<std::uint8_t>((value >> shift) & 0xffU));
  }
}

void Base64Writer::put(float value) {
  put(std::bit_cast<std::uint32_t>(value));
}

void Base64Writer::put(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  put(static_cast<std::uint32_t>(bits & 0xffffffffU));
  put(static_cast<std::uint32_t>(bits >> 32U));
}

void Base64Writer::put(std::uint8_t byte) {
  ++bytes_;
  group_[held_++] = byte;
  if (held_ == group_.size()) {
    write_group();
  }
}

void Base64Writer::write_group() {
  const std::uint32_t bits =
      (std::uint32_t{group_[0]} << 16) | (std::uint32_t{group_[1]} << 8) | std::uint32_t{group_[2]};
  for (const int shift : {18, 12, 6, 0}) {
    text_ += kDigits[(bits >> shift) & 0x3fU];
  }
  held_ = 0;
  group_ = {};
  if (text_.size() >= kPiece) {
    flush();
  }
}

void Base64Writer::flush() {
  out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
  text_.clear();
}

void Base64Writer::finish() {
  const std::size_t missing = held_ == 0 ? 0 : group_.size() - held_;
  if (missing > 0) {
    write_group();
    text_.replace(text_.size() - missing, missing, missing, '=');
  }
  flush();
}

}  // namespace soms::report
