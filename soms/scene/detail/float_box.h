/// \file
/// Boxes as floats, four lanes an end: what a broad phase sorts, keeps and compares.
#pragma once

#include "soms/base/box.h"

#include <limits>
#include <span>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace soms::detail {

/// Both ends of a box; the fourth lane is 0 and meets every other.
struct FloatBox {
  alignas(16) float lower[4];
  alignas(16) float upper[4];
};

/// True if every lane of `a` is at most that of `b`.
[[nodiscard]] inline bool at_most(const float* a, const float* b) {
#if defined(__SSE2__)
  return _mm_movemask_ps(_mm_cmple_ps(_mm_load_ps(a), _mm_load_ps(b))) == 15;
#else
  return (a[0] <= b[0]) & (a[1] <= b[1]) & (a[2] <= b[2]);
#endif
}

[[nodiscard]] inline bool meet(const FloatBox& a, const FloatBox& b) {
  return at_most(a.lower, b.upper) && at_most(b.lower, a.upper);
}

[[nodiscard]] inline bool holds(const FloatBox& outer, const FloatBox& inner) {
  return at_most(outer.lower, inner.lower) && at_most(inner.upper, outer.upper);
}

/// Where coordinates lie as floats: `float((v - origin) * scale)`. Each of the three operations
/// grows with `v`, so boxes that share a point still do as floats: no rounding outward is needed.
/// Boxes that are apart may meet; far from the origin, and beyond the range of floats, many do.
struct FloatMap {
  Vec3 origin;
  double scale = 1;

  /// The map for a set of boxes: its middle becomes the origin and its width about 1. Strays, up to
  /// an eighth of the boxes, do not count.
  [[nodiscard]] static FloatMap of(std::span<const Box> boxes);

  /// \pre `box` is not empty.
  [[nodiscard]] FloatBox operator()(const Box& box) const {
    return {{place(box.lower.x, origin.x), place(box.lower.y, origin.y),
             place(box.lower.z, origin.z), 0},
            {place(box.upper.x, origin.x), place(box.upper.y, origin.y),
             place(box.upper.z, origin.z), 0}};
  }

 private:
  [[nodiscard]] float place(double v, double from) const {
    return static_cast<float>((v - from) * scale);
  }
};

/// Stands for an empty box: meets none but boxes without end.
inline constexpr float kEndless = std::numeric_limits<float>::infinity();
inline constexpr FloatBox kNoBox{{kEndless, kEndless, kEndless, 0},
                                 {-kEndless, -kEndless, -kEndless, 0}};

}  // namespace soms::detail
