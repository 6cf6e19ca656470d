/// \file
/// Boxes as floats, four lanes an end: what a broad phase sorts, keeps and compares.
#pragma once

#include "soms/base/box.h"
#include "soms/base/lanes.h"

#include <cstring>
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

[[nodiscard]] inline lanes::F4 load(const float* from) {
  lanes::F4 v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

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

#if defined(__SSE2__)

[[nodiscard]] inline bool holds(const FloatBox& outer, const FloatBox& inner) {
  return _mm_movemask_ps(
             _mm_and_ps(_mm_cmple_ps(_mm_load_ps(outer.lower), _mm_load_ps(inner.lower)),
                        _mm_cmple_ps(_mm_load_ps(inner.upper), _mm_load_ps(outer.upper)))) == 15;
}

#else

[[nodiscard]] inline bool holds(const FloatBox& outer, const FloatBox& inner) {
  return at_most(outer.lower, inner.lower) & at_most(inner.upper, outer.upper);
}

#endif

/// What two boxes as floats say of the boxes that they stand for.
struct FloatVerdict {
  bool meet = false;  ///< false: the boxes are apart
  bool sure = false;  ///< and their insides meet
};

/// No operation of `FloatMap` makes of one number two, so ends that differ as floats differ.
[[nodiscard]] inline FloatVerdict compare(const FloatBox& a, const FloatBox& b) {
#if defined(__SSE2__)
  const __m128 lower_a = _mm_load_ps(a.lower);
  const __m128 upper_a = _mm_load_ps(a.upper);
  const __m128 lower_b = _mm_load_ps(b.lower);
  const __m128 upper_b = _mm_load_ps(b.upper);
  const int meet =
      _mm_movemask_ps(_mm_and_ps(_mm_cmple_ps(lower_a, upper_b), _mm_cmple_ps(lower_b, upper_a)));
  const int sure =
      _mm_movemask_ps(_mm_and_ps(_mm_cmplt_ps(lower_a, upper_b), _mm_cmplt_ps(lower_b, upper_a)));
  return {(meet & 7) == 7, (sure & 7) == 7};
#else
  unsigned meet = 1;
  unsigned sure = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    meet &= static_cast<unsigned>(a.lower[axis] <= b.upper[axis]) &
            static_cast<unsigned>(b.lower[axis] <= a.upper[axis]);
    sure &= static_cast<unsigned>(a.lower[axis] < b.upper[axis]) &
            static_cast<unsigned>(b.lower[axis] < a.upper[axis]);
  }
  return {meet != 0, sure != 0};
#endif
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

  /// An empty box becomes `kNoBox`.
  [[nodiscard]] FloatBox operator()(const Box& box) const {
    FloatBox floats;
#if defined(__SSE2__)
    const __m128d width = _mm_set1_pd(scale);
    const auto place = [&](double v, double next, double from, double from_next) {
      return _mm_cvtpd_ps(
          _mm_mul_pd(_mm_sub_pd(_mm_setr_pd(v, next), _mm_setr_pd(from, from_next)), width));
    };
    const __m128 first = place(box.lower.x, box.lower.y, origin.x, origin.y);
    const __m128 middle = place(box.lower.z, box.upper.x, origin.z, origin.x);
    const __m128 last = place(box.upper.y, box.upper.z, origin.y, origin.z);
    const __m128 xyz = _mm_castsi128_ps(_mm_setr_epi32(-1, -1, -1, 0));
    const __m128 upper = _mm_movelh_ps(middle, last);  // before its lanes: lower z
    _mm_store_ps(floats.lower, _mm_and_ps(_mm_movelh_ps(first, middle), xyz));
    _mm_store_ps(floats.upper,
                 _mm_and_ps(_mm_shuffle_ps(upper, upper, _MM_SHUFFLE(0, 3, 2, 1)), xyz));
#else
    for (std::size_t axis = 0; axis < 3; ++axis) {
      floats.lower[axis] = static_cast<float>((box.lower[axis] - origin[axis]) * scale);
      floats.upper[axis] = static_cast<float>((box.upper[axis] - origin[axis]) * scale);
    }
    floats.lower[3] = 0;
    floats.upper[3] = 0;
#endif
    return floats;
  }

  /// True if this map does for boxes whose own map is `other`.
  [[nodiscard]] bool serves(const FloatMap& other) const;
};

/// Stands for an empty box: meets none but boxes without end.
inline constexpr float kEndless = std::numeric_limits<float>::infinity();
inline constexpr FloatBox kNoBox{{kEndless, kEndless, kEndless, 0},
                                 {-kEndless, -kEndless, -kEndless, 0}};

}  // namespace soms::detail
