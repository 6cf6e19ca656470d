#include "apps/soms/overlap_parts.h"

#include "soms/geometry/crossing_segment.h"

#include <algorithm>
#include <unordered_map>

namespace soms::command {

namespace {

constexpr std::uint64_t kTightPairs = 1000;

/// More than the error of `crossing`, as a share of the extent of both triangles.
constexpr double kCrossingError = 4e-12;

Box intersection(const Box& a, const Box& b) {
  Box common;
  common.lower = {std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y),
                  std::max(a.lower.z, b.lower.z)};
  common.upper = {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y),
                  std::min(a.upper.z, b.upper.z)};
  return common;
}

}  // namespace

void grow_by_contact(Box& box, std::uint64_t count, const Triangle& a, const Triangle& b) {
  const Box shared = intersection(bounds(a), bounds(b));
  if (count >= kTightPairs || box.contains(shared)) {
    box.grow(shared);
    return;
  }
  Box both = bounds(a);
  both.grow(bounds(b));
  const Vec3 extent = both.extent();
  const double error = kCrossingError * std::max({extent.x, extent.y, extent.z});
  Box tight;
  const Crossing common = crossing(a, b);
  for (const Vec3& corner : common.points()) {
    tight.grow(corner - Vec3{error, error, error});
    tight.grow(corner + Vec3{error, error, error});
  }
  const Box inside = intersection(tight, shared);
  box.grow(inside.empty() ? shared : inside);
}

std::vector<PartPair> part_pairs(const PosedParts& a, const PosedParts& b,
                                 std::span<const TrianglePair> pairs) {
  std::unordered_map<std::uint64_t, PartPair> found;
  for (const TrianglePair& pair : pairs) {
    const std::uint32_t part_a = a.parts(pair.first);
    const std::uint32_t part_b = b.parts(pair.second);
    PartPair& row = found[(std::uint64_t{part_a} << 32) | part_b];
    if (row.count == 0) {
      row.a = part_a;
      row.b = part_b;
      row.first = pair;
    }
    grow_by_contact(row.box, row.count++, a.triangle(pair.first), b.triangle(pair.second));
  }
  std::vector<PartPair> rows;
  rows.reserve(found.size());
  for (const auto& [key, row] : found) {
    rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end(), [](const PartPair& x, const PartPair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  return rows;
}

}  // namespace soms::command
