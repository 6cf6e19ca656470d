#include "apps/soms/pairs/overlap_verify.h"

#include <algorithm>
#include <vector>

namespace soms::command {

bool agrees(const Overlap& answer, const Overlap& truth, OverlapMode mode) {
  if (answer.coverage == Coverage::cut) {
    return answer.any == !answer.pairs.empty() && (truth.any || !answer.any) &&
           std::includes(truth.pairs.begin(), truth.pairs.end(), answer.pairs.begin(),
                         answer.pairs.end());
  }
  if (answer.any != truth.any) {
    return false;
  }
  switch (mode) {
    case OverlapMode::all:
      return answer.pairs == truth.pairs;
    case OverlapMode::first:
      return !truth.any || answer.pairs == std::vector{truth.pairs.front()};
    case OverlapMode::any:
      break;
  }
  return !truth.any ||
         (answer.pairs.size() == 1 &&
          std::binary_search(truth.pairs.begin(), truth.pairs.end(), answer.pairs.front()));
}

}  // namespace soms::command
