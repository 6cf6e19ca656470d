#include "soms/base/crc32.h"

#include <array>

namespace soms {

namespace {

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value >> 1) ^ ((value & 1U) != 0 ? 0xedb88320U : 0U);
    }
    table[i] = value;
  }
  return table;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = crc_table();

}  // namespace

void Crc32::add(std::string_view bytes) {
  for (const char c : bytes) {
    state_ = (state_ >> 8) ^ kCrcTable[(state_ ^ static_cast<unsigned char>(c)) & 0xffU];
  }
}

}  // namespace soms
