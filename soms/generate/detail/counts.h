/// \file
/// The door of bodies with an exact number of triangles.
#pragma once

#include <cstdint>
#include <string>

namespace soms::detail {

/// Most triangles that a generated mesh has.
inline constexpr std::uint64_t kMostTriangles = 100'000'000;

/// Throws ErrorKind::usage unless `triangles` is even and between `least` and `kMostTriangles`;
/// names `what`, the least and the nearest possible count.
void check_closed_count(const std::string& what, std::uint64_t triangles, std::uint64_t least);

}  // namespace soms::detail
