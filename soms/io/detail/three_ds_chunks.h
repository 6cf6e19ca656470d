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

/// True for chunks of which a mesh is made, and those around them.
[[nodiscard]] constexpr bool holds_geometry(std::uint16_t name) {
  return name == kMain || name == kEditor || name == kObject || name == kTriangles ||
         name == kVertexList || name == kFaceList;
}

/// True for chunks that stand within a list of faces, behind the faces: materials, smoothing groups
/// and boxes of textures.
[[nodiscard]] constexpr bool belongs_to_faces(std::uint16_t name) {
  return name >= 0x4130 && name <= 0x41ff;
}

}  // namespace soms::detail::three_ds
