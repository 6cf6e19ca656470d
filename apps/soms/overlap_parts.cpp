#include "apps/soms/overlap_parts.h"

#include "soms/base/common_box.h"
#include "soms/geometry/crossing_segment.h"

#include "apps/report/placing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <unordered_map>

namespace soms::command {

namespace {

constexpr std::uint64_t kTightPairs = 1000;

/// More than the error of `crossing`, as a share of the extent of both triangles.
constexpr double kCrossingError = 4e-12;

/// Two roundings of a coordinate by `crossing`, one where the error is added, and one to spare.
constexpr double kRoundings = 4 * std::numeric_limits<double>::epsilon();

/// A stop is looked for once in so many pairs of triangles: tens of milliseconds.
constexpr std::size_t kPairsBetweenStops = 2048;

double largest_coordinate(const Box& box) {
  double largest = 0;
  for (const Vec3& corner : {box.lower, box.upper}) {
    largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  }
  return largest;
}

}  // namespace

void grow_by_contact(Box& box, std::uint64_t count, const Triangle& a, const Triangle& b) {
  const Box shared = common_box(bounds(a), bounds(b));
  if (count >= kTightPairs || box.contains(shared)) {
    box.grow(shared);
    return;
  }
  Box both = bounds(a);
  both.grow(bounds(b));
  const Vec3 extent = both.extent();
  const double error = kCrossingError * std::max({extent.x, extent.y, extent.z}) +
                       kRoundings * largest_coordinate(both);
  Box tight;
  const Crossing common = crossing(a, b);
  for (const Vec3& corner : common.points()) {
    tight.grow(corner - Vec3{error, error, error});
    tight.grow(corner + Vec3{error, error, error});
  }
  const Box inside = common_box(tight, shared);
  box.grow(inside.empty() ? shared : inside);
}

std::vector<PartPair> part_pairs(const PosedParts& a, const PosedParts& b,
                                 std::span<const TrianglePair> pairs, const Parallel& parallel,
                                 const EarlierContact& earlier) {
  struct Found {
    PartPair row;
    std::uint64_t before = 0;  ///< pairs of triangles that its box lies around already
  };

  std::unordered_map<std::uint64_t, Found> found;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (k % kPairsBetweenStops == 0) {
      check_stop(parallel);
    }
    const TrianglePair& pair = pairs[k];
    const std::uint32_t part_a = a.parts(pair.first);
    const std::uint32_t part_b = b.parts(pair.second);
    auto& [row, before] = found[part_key(part_a, part_b)];
    if (row.count == 0) {
      row = {.a = part_a, .b = part_b, .first = pair};
      if (earlier) {
        std::tie(before, row.box) = earlier(part_a, part_b);
      }
    }
    grow_by_contact(row.box, before + row.count++, a.triangle(pair.first), b.triangle(pair.second));
  }
  std::vector<PartPair> rows;
  rows.reserve(found.size());
  for (const auto& [key, each] : found) {
    rows.push_back(each.row);
  }
  std::sort(rows.begin(), rows.end(), [](const PartPair& x, const PartPair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  return rows;
}

}  // namespace soms::command
