/// \file
/// Which parts of two meshes overlap, from the pairs of triangles that do.
#pragma once

#include "soms/base/box.h"
#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/overlap.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace soms::command {

/// A mesh at a place, and the parts of its triangles.
struct PosedParts {
  MeshView mesh;
  const PartsOf& parts;
  const Pose& pose;

  [[nodiscard]] Triangle triangle(TriangleId i) const {
    const Triangle t = mesh.triangle(i);
    return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
  }
};

/// Two parts that overlap at one pose: indices in Mesh::parts, or Part::kNoParent for triangles
/// that no part holds.
struct PartPair {
  std::uint32_t a = Part::kNoParent;
  std::uint32_t b = Part::kNoParent;
  std::uint64_t count = 0;  ///< pairs of triangles
  TrianglePair first = {};  ///< the least of them
  Box box = {};             ///< holds every point that these triangles share
};

/// One number for a pair of parts.
[[nodiscard]] constexpr std::uint64_t part_key(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{a} << 32) | b;
}

/// How many pairs of triangles of two parts came before, and the box around what they share.
using EarlierContact =
    std::function<std::pair<std::uint64_t, Box>(std::uint32_t part_a, std::uint32_t part_b)>;

/// The pairs of parts of `pairs`, sorted by part of `a`, then of `b`. Boxes are grown from those of
/// `earlier`, where it is given; counts are of `pairs` alone.
/// \pre `pairs` are sorted.
/// \errors ErrorKind::cancelled.
[[nodiscard]] std::vector<PartPair> part_pairs(const PosedParts& a, const PosedParts& b,
                                               std::span<const TrianglePair> pairs,
                                               const Limits& limits = {},
                                               const EarlierContact& earlier = {});

}  // namespace soms::command
