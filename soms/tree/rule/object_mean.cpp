#include "soms/tree/rule/rules.h"

namespace soms::rule {

Split object_mean(const SplitNode& node, std::size_t axis) {
  double sum = 0;
  for (const Primitive& p : node.primitives) {
    sum += p.midpoint[axis];
  }
  return {axis, sum / static_cast<double>(node.primitives.size())};
}

}  // namespace soms::rule
