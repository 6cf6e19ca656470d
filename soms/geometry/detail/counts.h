/// \file
/// How many vertices and triangles a mesh may have.
#pragma once

#include <cstdint>
#include <string>

namespace soms {

/// Throws unless a mesh may have that many: at most `kMaxPrimitives` of either. For those who have
/// not allocated anything yet; `place` names the mesh. \errors ErrorKind::out_of_range.
void check_counts(std::uint64_t vertices, std::uint64_t triangles, const std::string& place);

/// What is wrong with an index that is not below `count`, for messages: "vertex 4, but vertices are
/// 0 to 3". `index` is "vertex 4", `items` is "vertices".
[[nodiscard]] std::string index_fault(const std::string& index, const std::string& items,
                                      std::uint64_t count);

}  // namespace soms
