/// \file
/// Chunks of 3DS that are read or written.
#pragma once

#include <cstddef>
#include <cstdint>

namespace soms::detail::three_ds {

/// Bytes of a chunk's header: a 16-bit name, and a 32-bit length that counts the header too.
inline constexpr std::size_t kChunkHeader = 6;

inline constexpr std::uint16_t kVersion = 0x0002;
inline constexpr std::uint16_t kMain = 0x4d4d;
inline constexpr std::uint16_t kEditor = 0x3d3d;
inline constexpr std::uint16_t kMeshVersion = 0x3d3e;
inline constexpr std::uint16_t kMasterScale = 0x0100;
inline constexpr std::uint16_t kObject = 0x4000;
inline constexpr std::uint16_t kTriangles = 0x4100;
inline constexpr std::uint16_t kVertexList = 0x4110;
inline constexpr std::uint16_t kFaceList = 0x4120;
inline constexpr std::uint16_t kKeyframes = 0xb000;

}  // namespace soms::detail::three_ds
