#include "apps/soms/pairs/overlap_parts.h"

#include "soms/geometry/contact_box.h"

#include "apps/report/placing.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <unordered_map>

namespace soms::command {

namespace {

/// A stop is looked for once in so many pairs of triangles: tens of milliseconds.
constexpr std::size_t kPairsBetweenStops = 2048;

}  // namespace

std::vector<PartPair> part_pairs(const PosedParts& a, const PosedParts& b,
                                 std::span<const TrianglePair> pairs, const Limits& limits,
                                 const EarlierContact& earlier) {
  struct Found {
    PartPair row;
    std::uint64_t before = 0;  ///< pairs of triangles that its box lies around already
  };

  std::unordered_map<std::uint64_t, Found> found;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (k % kPairsBetweenStops == 0) {
      check_stop(limits);
    }
    const TrianglePair& pair = pairs[k];
    const std::uint32_t part_a = a.parts(pair.a);
    const std::uint32_t part_b = b.parts(pair.b);
    auto& [row, before] = found[part_key(part_a, part_b)];
    if (row.count == 0) {
      row = {.a = part_a, .b = part_b, .first = pair};
      if (earlier) {
        std::tie(before, row.box) = earlier(part_a, part_b);
      }
    }
    grow_by_contact(row.box, before + row.count++, a.triangle(pair.a), b.triangle(pair.b));
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
