/// \file
/// Triangles of one mesh with the same corners.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/answer.h"
#include "soms/query/detail/self/self_frame.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// Lists the pairs of triangles with the same corners, sorted; false where there are more than
/// `limit`.
/// \errors ErrorKind::cancelled.
[[nodiscard]] bool list_duplicates(const SelfFrame& frame, std::uint64_t limit,
                                   const Limits& limits, std::vector<TrianglePair>& pairs);

}  // namespace soms::detail
