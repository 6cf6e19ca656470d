#include "soms/thesis/detail/recursion.h"

#include "soms/base/error.h"
#include "soms/thesis/traversals.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace soms::detail {

namespace {

std::uint32_t depth(const Tree& tree) {
  const auto deepest = std::max_element(
      tree.nodes.begin(), tree.nodes.end(),
      [](const Node& left, const Node& right) { return left.depth < right.depth; });
  return deepest->depth;
}

}  // namespace

void check_recursion(const PosedTree& a, const PosedTree& b) {
  const std::uint64_t nesting = std::uint64_t{depth(*a.tree)} + depth(*b.tree) + 1;
  if (nesting > kMaxRecursion) {
    throw Error(ErrorKind::usage,
                "recursive traversal: depths of " + std::to_string(depth(*a.tree)) + " and " +
                    std::to_string(depth(*b.tree)) + " need " + std::to_string(nesting) +
                    " nested calls, above " + std::to_string(kMaxRecursion),
                "leave `recursive` off: the explicit stack has no limit");
  }
}

}  // namespace soms::detail
