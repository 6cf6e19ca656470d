/// \file
/// Chunks of 3DS that are read or written.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

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

/// True for chunks that add no shape, wherever they stand: versions and colors, settings of the
/// editor, flags of objects, what a mesh has beside its lists, lights, cameras, data of plug-ins,
/// materials, and keyframes.
[[nodiscard]] constexpr bool adds_no_shape(std::uint16_t name) {
  constexpr std::array<std::pair<std::uint16_t, std::uint16_t>, 26> kRanges = {{
      {0x0002, 0x0005}, {0x0010, 0x0013}, {0x0030, 0x0031}, {0x0100, 0x0100}, {0x1100, 0x1101},
      {0x1200, 0x1201}, {0x1300, 0x1301}, {0x1400, 0x1460}, {0x1500, 0x1500}, {0x2100, 0x2100},
      {0x2200, 0x2210}, {0x2300, 0x2310}, {0x3000, 0x3090}, {0x3d3e, 0x3d3e}, {0x4010, 0x4017},
      {0x4111, 0x4111}, {0x4130, 0x4130}, {0x4140, 0x4140}, {0x4150, 0x4150}, {0x4160, 0x4190},
      {0x4600, 0x4660}, {0x4700, 0x4720}, {0x7001, 0x7030}, {0x8000, 0x80ff}, {0xa000, 0xafff},
      {0xb000, 0xb0ff},
  }};
  return std::any_of(kRanges.begin(), kRanges.end(), [&](const auto& range) {
    return range.first <= name && name <= range.second;
  });
}

/// True for chunks that stand within a list of faces, behind the faces: materials, smoothing groups
/// and boxes of textures.
[[nodiscard]] constexpr bool belongs_to_faces(std::uint16_t name) {
  return name >= 0x4130 && name <= 0x41ff;
}

}  // namespace soms::detail::three_ds
