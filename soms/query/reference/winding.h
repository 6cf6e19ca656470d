/// \file
/// The brute-force twin of `winding`: every triangle, no tree, no boundary, no ray.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/query/body.h"

#include <span>
#include <vector>

namespace soms::reference {

/// A bracket for the winding number, as `soms::winding` means it: the sum of the solid angles of
/// all triangles in long double, with bounds on the rounding. On platforms where that has more
/// digits than double it is narrower by them. Trusts the C library's arctangent to 8 units in the
/// last place, so its bits may differ between platforms: for tests and `--verify`, not for answers.
/// \errors As for a query of the mesh at the pose.
/// \cost   O(n) for each point.
/// \source Van Oosterom and Strackee 1983, The Solid Angle of a Plane Triangle.
[[nodiscard]] Bracket winding_by_brute_force(const Body& body, const Vec3& point);

/// The same for points, in order; the body is moved once.
[[nodiscard]] std::vector<Bracket> winding_by_brute_force(const Body& body,
                                                          std::span<const Vec3> points);

}  // namespace soms::reference
