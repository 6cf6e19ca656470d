/// \file
/// Signed distances as single numbers.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/closest.h"
#include "soms/query/contains.h"

#include <vector>

namespace soms::python {

/// The least double that is not below the distance, below 0 inside; 0 on the surface, infinite
/// where it is farther than the limit, NaN where side or distance are not known.
[[nodiscard]] double signed_distance(double upper, Side side, Coverage coverage);

/// The same for n points. \shape n each.
[[nodiscard]] std::vector<double> signed_distances(const ClosestBatch& closest,
                                                   const std::vector<Side>& sides);

}  // namespace soms::python
