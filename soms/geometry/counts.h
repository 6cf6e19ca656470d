/// \file
/// How many vertices and triangles a mesh may have.
#pragma once

#include <cstdint>
#include <string>

namespace soms {

/// Throws unless a mesh may have that many: at most `kMaxPrimitives` of either. For those who have
/// not allocated anything yet; `place` names the mesh. \errors ErrorKind::out_of_range.
void check_counts(std::uint64_t vertices, std::uint64_t triangles, const std::string& place);

}  // namespace soms
