#include "soms/tree/rule/rules.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace soms::rule {

Split object_median(const SplitNode& node, std::size_t axis) {
  using Key = std::pair<double, TriangleId>;
  std::vector<Key> keys(node.primitives.size());
  std::transform(node.primitives.begin(), node.primitives.end(), keys.begin(),
                 [axis](const Primitive& p) {
                   return Key{p.midpoint[axis], p.id};
                 });
  const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
  std::nth_element(keys.begin(), middle, keys.end());
  return {axis, middle->first, middle->second};
}

}  // namespace soms::rule
