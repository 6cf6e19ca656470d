#include "soms/scene/reference/broad_phase.h"

#include <algorithm>
#include <cstdint>

namespace soms::reference {

std::vector<BoxPair> meeting_pairs(std::span<const Box> boxes,
                                   std::span<const std::uint32_t> groups,
                                   std::span<const BoxPair> ignored) {
  const auto group = [&](std::uint32_t k) { return k < groups.size() ? groups[k] : 0; };
  const auto left_out = [&](std::uint32_t a, std::uint32_t b) {
    return (group(a) != 0 && group(a) == group(b)) ||
           std::find(ignored.begin(), ignored.end(), BoxPair(a, b)) != ignored.end() ||
           std::find(ignored.begin(), ignored.end(), BoxPair(b, a)) != ignored.end();
  };
  std::vector<BoxPair> pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      if (overlaps(boxes[a], boxes[b]) && !left_out(a, b)) {
        pairs.emplace_back(a, b);
      }
    }
  }
  return pairs;
}

}  // namespace soms::reference
