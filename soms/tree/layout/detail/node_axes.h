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

/// How points and the triangles between them lie about a place: enough to choose axes by, and sums,
/// so that those of a node are made of its children's.
struct Moments {
  double points = 0;
  std::array<double, 3> sum = {};
  std::array<double, 3> square = {};   ///< sums of x x, y y, z z
  std::array<double, 3> product = {};  ///< sums of x y, y z, z x
  std::array<double, 3> normal = {};   ///< sum of twice the triangles' area vectors
  double area = 0;                     ///< sum of the 1-norms of these

  /// Adds what lies about another place, which is seen at `offset` from here.
  void add(const Moments& other, const Vec3& offset);
};

/// Axes in which what the moments tell of fills a small box. Where triangles mostly face one way,
/// their mean normal and the principal axes of the plane across it; else the principal axes.
/// \cost O(1)
[[nodiscard]] Axes axes_of(const Moments& moments);

/// Coordinates of `v` along axes.
[[nodiscard]] inline Vec3 along(const Axes& axes, const Vec3& v) {
  Vec3 out;
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = (axes[k] * v.x + axes[3 + k] * v.y) + axes[6 + k] * v.z;
  }
  return out;
}

}  // namespace soms::layout
