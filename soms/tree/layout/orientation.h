/// \file
/// Frames in which a few points fill small boxes.
#pragma once

#include "soms/base/vector.h"

#include <array>
#include <span>

namespace soms::layout {

/// A rotation or reflection as floats, row-major: columns are the axes. Each entry is rounded once,
/// so columns are orthonormal to 2^-23.
using Axes = std::array<float, 9>;

inline constexpr Axes kMeshAxes{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Principal axes of points, by Jacobi's method; the mesh's axes where all points are one.
/// \cost   O(n). The same bits on every machine: only sums, products and square roots.
/// \source Golub and Van Loan 2013, section 8.5.
[[nodiscard]] Axes principal_axes(std::span<const Vec3> points);

/// Coordinates of `v` along axes.
[[nodiscard]] inline Vec3 along(const Axes& axes, const Vec3& v) {
  Vec3 out;
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = (axes[k] * v.x + axes[3 + k] * v.y) + axes[6 + k] * v.z;
  }
  return out;
}

}  // namespace soms::layout
