#include "apps/soms/probes/winding_verify.h"

namespace soms::command {

bool agrees(const Bracket& number, const Bracket& truth) {
  // Written so that NaN fails.
  return number.lower <= number.upper && number.lower <= truth.upper &&
         number.upper >= truth.lower && truth.lower <= truth.upper;
}

}  // namespace soms::command
