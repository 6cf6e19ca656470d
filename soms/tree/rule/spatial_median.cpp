#include "soms/tree/rule/rules.h"

namespace soms::rule {

Split spatial_median(const SplitNode& node, std::size_t axis) {
  return {axis, 0.5 * (node.outer.lower[axis] + node.outer.upper[axis])};
}

}  // namespace soms::rule
