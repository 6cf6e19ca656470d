/// \file
/// Where the nodes of a scene put their vertices.
#pragma once

#include "soms/base/vector.h"

#include <array>

namespace soms::detail {

/// Three rows of four: p' = ((m0 x + m1 y) + m2 z) + m3, likewise y' and z'.
struct Affine {
  std::array<double, 12> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  [[nodiscard]] bool operator==(const Affine&) const = default;

  [[nodiscard]] Vec3 apply(const Vec3& p) const;
  /// True if it turns outlines around: its determinant is negative.
  [[nodiscard]] bool mirrors() const;
};

/// First `b`, then `a`.
[[nodiscard]] Affine operator*(const Affine& a, const Affine& b);

}  // namespace soms::detail
