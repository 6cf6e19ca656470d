/// \file
/// Which vertices are in one place.
#pragma once

#include "soms/geometry/detail/parts/buckets.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// Stands for a vertex that no triangle uses.
inline constexpr std::uint32_t kUnused = 0xffffffffU;

/// For each vertex the least used vertex in its place (-0 equals 0), or kUnused. Takes
/// `joining_work` of `work`, 10 bytes a vertex while it runs and 4 afterwards.
[[nodiscard]] std::vector<std::uint32_t> joined_by_position(const MeshView& mesh, Work& work);

/// Loops of `joined_by_position`.
[[nodiscard]] std::uint64_t joining_work(const MeshView& mesh);

}  // namespace soms::detail
