/// \file
/// What must hold for every question about a point and a body.
#pragma once

#include "soms/base/vector.h"
#include "soms/query/body.h"

#include <cstddef>
#include <string>

namespace soms::test {

/// What is wrong with the answers about a point: `closest` with limits at and beside the distance,
/// alone and in a batch, `nearest_triangles` and `near_triangles`, against the twins. Empty if
/// nothing is.
[[nodiscard]] std::string first_fault_of_point(const Body& body, const Vec3& point);

}  // namespace soms::test
