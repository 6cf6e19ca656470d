#include "soms/tree/rule/rules.h"

namespace soms::rule {

Split soms(const SplitNode& node, std::size_t axis) {
  const double lower = node.inner.lower[axis];
  const double upper = node.inner.upper[axis];
  const double middle = 0.5 * (lower + upper);
  // Between neighboring doubles the middle rounds to one of them: the upper one divides.
  return {axis, middle > lower ? middle : upper};
}

}  // namespace soms::rule
