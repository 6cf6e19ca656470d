#include "soms/tree/statistics.h"

#include "soms/base/arithmetic.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace soms {

namespace {

void count_leaf(const Node& node, const BuildOptions& options, TreeStatistics& s) {
  const bool last = options.level > 0 &&
                    node.depth == static_cast<std::uint32_t>(options.level - options.root_level);
  ++s.leaves;
  s.one += node.count == 1;
  s.lt5 += node.count < 5;
  s.capped += last && node.count > static_cast<std::uint32_t>(options.per_leaf);
  s.min_leaf_depth = std::min<std::uint64_t>(s.min_leaf_depth, node.depth);
  s.max_leaf_depth = std::max<std::uint64_t>(s.max_leaf_depth, node.depth);
  s.largest_leaf = std::max<std::uint64_t>(s.largest_leaf, node.count);
}

}  // namespace

TreeStatistics statistics(const Tree& tree, const BuildOptions& options) {
  TreeStatistics s;
  if (tree.nodes.empty()) {
    return s;
  }
  s.nodes = tree.nodes.size();
  s.min_leaf_depth = std::numeric_limits<std::uint64_t>::max();
  std::vector<std::uint64_t> filled;  // nodes that hold a triangle, at each depth
  for (const Node& node : tree.nodes) {
    s.depth = std::max<std::uint64_t>(s.depth, node.depth);
    s.undividable += node.undividable;
    if (node.count == 0) {
      ++s.empty;
      continue;
    }
    if (filled.size() <= node.depth) {
      filled.resize(node.depth + 1);
    }
    ++filled[node.depth];
    if (node.is_leaf()) {
      count_leaf(node, options, s);
    }
  }
  while (s.balanced_level < std::min<std::size_t>(filled.size(), 64) &&
         filled[s.balanced_level] == std::uint64_t{1} << s.balanced_level) {
    ++s.balanced_level;
  }
  return s;
}

double sah_cost(const Tree& tree, double triangle_cost) {
  const PlainArithmetic plain;
  if (tree.nodes.empty()) {
    return 0;
  }
  double sum = 0;
  for (const Node& node : tree.nodes) {
    sum += half_area(node.bounds) * (node.is_leaf() ? node.count * triangle_cost : 1);
  }
  const double root = half_area(tree.nodes[0].bounds);
  return settled(root > 0 ? sum / root : 0);
}

}  // namespace soms
