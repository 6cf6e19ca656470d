#include "apps/soms/clash/bcf_guid.h"

#include <sha1.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::command {

namespace {

/// The namespace of our names, a UUID that was drawn once.
constexpr std::array<std::uint8_t, 16> kBcfNamespace{
    0x6f, 0x1d, 0x3b, 0x52, 0x0a, 0x94, 0x4c, 0x7e, 0x9d, 0x21, 0x58, 0xe3, 0xc6, 0x4b, 0x70, 0x1f};

constexpr std::string_view kIfcDigits =
    "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";

}  // namespace

std::string bcf_guid(std::string_view name) {
  SHA1_CTX state{};
  SHA1Init(&state);
  SHA1Update(&state, kBcfNamespace.data(), kBcfNamespace.size());
  SHA1Update(&state, reinterpret_cast<const std::uint8_t*>(name.data()), name.size());
  std::array<std::uint8_t, SHA1_DIGEST_LENGTH> digest{};
  SHA1Final(digest.data(), &state);
  digest[6] = static_cast<std::uint8_t>((digest[6] & 0x0fU) | 0x50U);  // version 5
  digest[8] = static_cast<std::uint8_t>((digest[8] & 0x3fU) | 0x80U);  // variant of RFC 9562
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t k = 0; k < 16; ++k) {
    if (k == 4 || k == 6 || k == 8 || k == 10) {
      text += '-';
    }
    text += kHexDigits[digest[k] >> 4U];
    text += kHexDigits[digest[k] & 0x0fU];
  }
  return text;
}

bool is_ifc_guid(std::string_view id) {
  return id.size() == 22 && id.front() >= '0' && id.front() <= '3' &&
         std::all_of(id.begin(), id.end(),
                     [](char digit) { return kIfcDigits.find(digit) != std::string_view::npos; });
}

}  // namespace soms::command
