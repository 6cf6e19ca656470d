/// \file
/// Do the ends of a shortest segment hold what `distance` promises of them?
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <string>

namespace soms::test {

/// A triangle of a body, moved.
[[nodiscard]] Triangle moved_triangle(const Body& body, TriangleId id);

/// A body of one triangle.
[[nodiscard]] Body body_of(const Triangle& t);

/// The distance of triangle `pair.a` of `a` from triangle `pair.b` of `b`, by itself.
[[nodiscard]] Bracket distance_of_pair(const Body& a, const Body& b, const TrianglePair& pair);

/// What is wrong with the points `p` and `q` of a pair at distance `d`; empty if nothing is. Each
/// must lie on its triangle, and |p - q| must be in `d`, up to 4 units in the last place of the
/// largest coordinate of the pair for each end. Decided exactly.
[[nodiscard]] std::string fault_of_points(const Body& a, const Body& b, const TrianglePair& pair,
                                          const Vec3& p, const Vec3& q, const Bracket& d);

}  // namespace soms::test
