/// \file
/// Axis-aligned boxes (AABB).
#pragma once

#include "soms/base/vector.h"

#include <algorithm>
#include <limits>

namespace soms {

/// Closed axis-aligned box. A default box is empty (`lower` is +infinity, `upper` -infinity): it
/// overlaps nothing and is the neutral element of `merge`.
struct Box {
  Vec3 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Vec3 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
             -std::numeric_limits<double>::infinity()};

  [[nodiscard]] constexpr bool operator==(const Box&) const = default;

  [[nodiscard]] constexpr bool empty() const {
    return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z);
  }

  /// Side lengths; negative infinity in an empty box.
  [[nodiscard]] constexpr Vec3 extent() const { return upper - lower; }

  [[nodiscard]] constexpr Vec3 center() const {
    return {0.5 * (lower.x + upper.x), 0.5 * (lower.y + upper.y), 0.5 * (lower.z + upper.z)};
  }

  constexpr void grow(const Vec3& p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }

  constexpr void grow(const Box& b) {
    lower = {std::min(lower.x, b.lower.x), std::min(lower.y, b.lower.y),
             std::min(lower.z, b.lower.z)};
    upper = {std::max(upper.x, b.upper.x), std::max(upper.y, b.upper.y),
             std::max(upper.z, b.upper.z)};
  }

  /// True if `b` lies inside this box, boundary included.
  [[nodiscard]] constexpr bool contains(const Box& b) const {
    return lower.x <= b.lower.x && lower.y <= b.lower.y && lower.z <= b.lower.z &&
           upper.x >= b.upper.x && upper.y >= b.upper.y && upper.z >= b.upper.z;
  }
};

/// True if two closed boxes share a point: touching counts.
[[nodiscard]] constexpr bool overlaps(const Box& a, const Box& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
         b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

/// Bounds of a triangle's corners.
[[nodiscard]] constexpr Box bounds(const Triangle& t) {
  Box box;
  box.grow(t.a);
  box.grow(t.b);
  box.grow(t.c);
  return box;
}

/// Volume of a box; 0 for an empty one.
[[nodiscard]] constexpr double volume(const Box& b) {
  if (b.empty()) {
    return 0;
  }
  const Vec3 e = b.extent();
  return e.x * e.y * e.z;
}

/// Half the surface area of a box; 0 for an empty one.
[[nodiscard]] constexpr double half_area(const Box& b) {
  if (b.empty()) {
    return 0;
  }
  const Vec3 e = b.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

}  // namespace soms
