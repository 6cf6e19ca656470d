/// \file
/// The corners, edges and faces of two triangles between which a shortest segment runs.
#pragma once

#include "soms/base/vector.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// A corner, an edge or the face of a triangle: the set of its corners, one bit each.
using Feature = std::uint8_t;

inline constexpr Feature kFace = 7;

/// 1 for a corner, 2 for an edge, 3 for the face.
[[nodiscard]] constexpr int corner_count(Feature feature) {
  return (feature & 1) + (feature >> 1 & 1) + (feature >> 2 & 1);
}

/// The lowest of a feature's corners, and the highest.
[[nodiscard]] constexpr std::size_t first_corner(Feature feature) {
  return static_cast<std::size_t>(std::countr_zero(feature));
}

[[nodiscard]] constexpr std::size_t last_corner(Feature feature) {
  return feature >= 4 ? 2 : feature >= 2 ? 1 : 0;
}

/// Features of two triangles, that of the first in [0].
using FeaturePair = std::array<Feature, 2>;

/// All that can be nearest: corners, edges and corners, faces and corners, and edges.
inline constexpr std::array<FeaturePair, 42> kFeaturePairs = [] {
  std::array<FeaturePair, 42> pairs{};
  std::size_t count = 0;
  constexpr std::array<Feature, 7> kFeatures{1, 2, 4, 3, 5, 6, kFace};
  for (const Feature a : kFeatures) {
    for (const Feature b : kFeatures) {
      if (corner_count(a) + corner_count(b) <= 4) {
        pairs[count++] = {a, b};
      }
    }
  }
  return pairs;
}();

static_assert(kFeaturePairs.back()[0] == kFace);

[[nodiscard]] constexpr const Vec3& corner(const Triangle& t, std::size_t i) {
  return i == 0 ? t.a : i == 1 ? t.b : t.c;
}

/// Whether all corners of a feature have one coordinate in common.
[[nodiscard]] constexpr bool is_level(const Triangle& t, Feature feature, std::size_t axis) {
  const double level = corner(t, first_corner(feature))[axis];
  for (std::size_t i = 0; i < 3; ++i) {
    if ((feature >> i & 1) != 0 && corner(t, i)[axis] != level) {
      return false;
    }
  }
  return true;
}

/// Whether features of two triangles have the same corners, in any order.
[[nodiscard]] inline bool same_corners(const Triangle& s, Feature f, const Triangle& t, Feature g) {
  if (corner_count(f) != corner_count(g)) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    bool found = (f >> i & 1) == 0;
    for (std::size_t j = 0; j < 3; ++j) {
      found = found || ((g >> j & 1) != 0 && corner(s, i) == corner(t, j));
    }
    if (!found) {
      return false;
    }
  }
  return true;
}

}  // namespace soms::detail
