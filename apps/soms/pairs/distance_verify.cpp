#include "apps/soms/pairs/distance_verify.h"

namespace soms::command {

bool agrees(const Distance& answer, const Distance& truth, double at_most) {
  const auto& [lower, upper] = answer.distance;
  const Bracket& exact = truth.distance;
  if (answer.farther) {
    // A distance that is not a double lies below the upper end of its bracket.
    return exact.upper > at_most && lower >= at_most && lower <= exact.lower && !answer.triangles;
  }
  if (answer.coverage == Coverage::cut) {
    return lower <= exact.lower && exact.upper <= upper;
  }
  return answer.distance == exact && answer.triangles == truth.triangles;
}

}  // namespace soms::command
