/// \file
/// The bytes that writer and reader of recordings agree on; docs/recording.md describes them.
#pragma once

#include "soms/base/byte_fields.h"
#include "soms/base/hash.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace soms::detail {

/// First bytes of a file: no text begins so, and a transfer as text breaks them.
inline constexpr std::string_view kRecordingMagic{"\x89SOMS\r\n\x1a", 8};
inline constexpr std::uint32_t kContactsVersion = 1;  ///< frames hold poses and contacts
inline constexpr std::uint32_t kGapsVersion = 2;      ///< and gaps; the head holds the clearance
inline constexpr std::uint32_t kPassagesVersion = 3;  ///< and passages; the clearance may be 0
inline constexpr std::size_t kFileHeadSize = 16;      ///< magic, version, check
inline constexpr std::size_t kChunkHeadSize = 32;     ///< tag, frames, first frame, length, check
inline constexpr std::size_t kCheckSize = 8;          ///< behind a chunk's content

/// Bytes of a contact: four numbers. Of a gap: these, a bracket and two points.
inline constexpr std::size_t kContactSize = 16;
inline constexpr std::size_t kGapSize = kContactSize + 8 * 8;
/// Of a passage: a contact, a verdict, a bracket and a point.
inline constexpr std::size_t kPassageSize = kContactSize + 1 + 5 * 8;

/// A chunk is written when it holds so many bytes or frames.
inline constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
inline constexpr std::uint32_t kChunkFrames = 64;

inline constexpr std::string_view kHeadTag = "HEAD";
inline constexpr std::string_view kFramesTag = "FRAM";
inline constexpr std::string_view kEndTag = "DONE";

/// What a chunk says of itself.
struct ChunkHead {
  std::array<char, 4> tag{};
  std::uint32_t frames = 0;
  std::uint64_t first = 0;   ///< number of its first frame
  std::uint64_t length = 0;  ///< bytes of its content

  [[nodiscard]] bool is(std::string_view name) const {
    return std::string_view(tag.data(), tag.size()) == name;
  }
};

[[nodiscard]] inline std::uint64_t hash_of(std::string_view bytes) {
  Fnv1a hash;
  for (const char byte : bytes) {
    hash.add_byte(static_cast<std::uint8_t>(byte));
  }
  return hash.value();
}

}  // namespace soms::detail
