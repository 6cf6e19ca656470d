#include "soms/query/reference/overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/base/parallel.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/reference/detail/moved_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::reference {

namespace {

/// Triangles of `a` that are taken together: the unit of work of a thread.
constexpr std::size_t kChunk = 16;

/// Boxes of `b` that are swept together: 96 KiB, so that they stay in the cache for a whole chunk.
constexpr std::size_t kTile = 2048;

using detail::BoxArrays;
using detail::moved_triangles;

using Flags = std::array<std::uint64_t, kTile>;

/// Sets `flags[i]` to whether the closed box `first + i` of `boxes` meets `box`.
void flag_boxes(const BoxArrays& boxes, std::size_t first, std::size_t count, const Box& box,
                Flags& flags) {
  const double* const lower_x = boxes.lower[0].data() + first;
  const double* const lower_y = boxes.lower[1].data() + first;
  const double* const lower_z = boxes.lower[2].data() + first;
  const double* const upper_x = boxes.upper[0].data() + first;
  const double* const upper_y = boxes.upper[1].data() + first;
  const double* const upper_z = boxes.upper[2].data() + first;
  const Vec3 lower = box.lower;
  const Vec3 upper = box.upper;
  for (std::size_t i = 0; i < count; ++i) {
    const bool x = (lower_x[i] <= upper.x) & (lower.x <= upper_x[i]);
    const bool y = (lower_y[i] <= upper.y) & (lower.y <= upper_y[i]);
    const bool z = (lower_z[i] <= upper.z) & (lower.z <= upper_z[i]);
    flags[i] = static_cast<std::uint64_t>(x & y & z);
  }
}

/// Answer of one chunk of triangles of `a`.
Overlap scan(const std::vector<Triangle>& a, std::size_t begin, std::size_t end,
             const std::vector<Triangle>& b, const BoxArrays& boxes) {
  Overlap part;
  Flags flags;
  for (std::size_t first = 0; first < b.size(); first += kTile) {
    const std::size_t count = std::min(kTile, b.size() - first);
    for (std::size_t i = begin; i < end; ++i) {
      flag_boxes(boxes, first, count, bounds(a[i]), flags);
      part.cost.node_tests += count;
      for (std::size_t k = 0; k < count; ++k) {
        if (flags[k] == 0) {
          continue;
        }
        ++part.cost.triangle_tests;
        if (triangles_overlap(a[i], b[first + k], &part.cost.exact_tests)) {
          part.pairs.push_back({static_cast<TriangleId>(i), static_cast<TriangleId>(first + k)});
        }
      }
    }
  }
  std::sort(part.pairs.begin(), part.pairs.end());
  return part;
}

}  // namespace

Overlap overlap(const MeshView& a, const Pose& pose_a, const MeshView& b, const Pose& pose_b,
                const Limits& limits) {
  const PlainArithmetic plain;
  const std::vector<Triangle> first = moved_triangles(a, pose_a);
  const std::vector<Triangle> second = moved_triangles(b, pose_b);
  const BoxArrays boxes(second);
  std::vector<Overlap> parts((first.size() + kChunk - 1) / kChunk);
  for_each_chunk(first.size(), kChunk, limits, [&](std::size_t begin, std::size_t end) {
    parts[begin / kChunk] = scan(first, begin, end, second, boxes);
  });
  Overlap answer;
  for (const Overlap& part : parts) {
    answer.pairs.insert(answer.pairs.end(), part.pairs.begin(), part.pairs.end());
    answer.cost += part.cost;
  }
  answer.any = !answer.pairs.empty();
  return answer;
}

}  // namespace soms::reference
