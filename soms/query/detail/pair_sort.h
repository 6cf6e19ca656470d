/// \file
/// Sorting of pairs of triangles.
#pragma once

#include "soms/query/overlap.h"

#include <span>

namespace soms::detail {

/// Sorts pairs in ascending order.
/// \cost O(n) for many pairs, with memory for two copies of them.
void sort_pairs(std::span<TrianglePair> pairs);

}  // namespace soms::detail
