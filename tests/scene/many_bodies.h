/// \file
/// Sets of bodies for tests of queries of many, and lines among them.
#pragma once

#include "soms/base/random.h"
#include "soms/base/vector.h"
#include "soms/query/body.h"
#include "soms/query/ray.h"

#include <cstdint>
#include <vector>

namespace soms::test {

/// Up to 40 bodies of a kind: scattered, crowded so that many touch, copies in one place, on a
/// lattice, far from the origin, of scales far apart. Some are empty; every layout occurs.
[[nodiscard]] std::vector<Body> many_bodies(Rng& rng);

/// A point among bodies: anywhere, on a corner, in the middle of an edge, or far away.
[[nodiscard]] Vec3 point_among(const std::vector<Body>& bodies, Rng& rng);

/// A ray from one such point to another, or along an axis, of a length up to infinity.
[[nodiscard]] Ray ray_among(const std::vector<Body>& bodies, Rng& rng);

}  // namespace soms::test
