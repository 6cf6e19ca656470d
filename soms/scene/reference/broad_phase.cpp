#include "soms/scene/reference/broad_phase.h"

#include <cstdint>

namespace soms::reference {

std::vector<BoxPair> meeting_pairs(std::span<const Box> boxes) {
  std::vector<BoxPair> pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      if (overlaps(boxes[a], boxes[b])) {
        pairs.emplace_back(a, b);
      }
    }
  }
  return pairs;
}

}  // namespace soms::reference
