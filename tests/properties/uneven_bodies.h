/// \file
/// Bodies of one size with triangles of far smaller ones, side by side.
#pragma once

#include "soms/base/random.h"
#include "soms/base/vector.h"
#include "soms/geometry/mesh.h"
#include "soms/query/ray.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::test {

/// Sizes as exponents of 2: of the bodies, and of what is tiny in them.
struct Sizes {
  int body = 0;
  int tiny = 0;
};

/// Sizes from bodies of 2^-1070 to 2^300, with triangles of 2^0 to 2^-60 of each: every `step`-th
/// exponent, and each one where layouts change their unit and where floats and doubles underflow.
[[nodiscard]] std::vector<Sizes> all_sizes(int step);

/// Two meshes, and where their tiny triangles are.
struct UnevenBodies {
  Mesh a;
  Mesh b;
  std::vector<Vec3> places;
  bool closed = false;  ///< both are made of tetrahedra
};

/// Meshes of up to 30 triangles: some as large as the body, most tiny, the rest between, the tiny
/// ones of both near the same places. Now and then the second is a single point, or tiny as a
/// whole, or a little off.
[[nodiscard]] UnevenBodies uneven_bodies(const Sizes& sizes, Rng& rng);

/// Points on, beside and near tiny triangles, and one far from them.
[[nodiscard]] std::vector<Vec3> points_at(const UnevenBodies& bodies, const Sizes& sizes, Rng& rng);

/// Rays from such points and from outside to others, and along axes.
[[nodiscard]] std::vector<Ray> rays_at(const UnevenBodies& bodies, const Sizes& sizes, Rng& rng);

}  // namespace soms::test
