#include "reproduce/balance_measures.h"

#include "soms/tree/statistics.h"

#include <bit>
#include <cstdint>

namespace soms::reproduce {

namespace {

/// Least sum of the depths of so many leaves: those of a tree whose depths differ by at most one.
double least_depth_sum(std::uint64_t leaves) {
  const auto depth = static_cast<std::uint64_t>(std::bit_width(leaves)) - 1;
  return static_cast<double>(leaves * depth + 2 * (leaves - (std::uint64_t{1} << depth)));
}

double depth_excess(const Tree& tree, std::uint64_t leaves) {
  double sum = 0;
  for (const Node& node : tree.nodes) {
    sum += node.is_leaf() && node.count > 0 ? node.depth : 0;
  }
  return leaves == 0 ? 0 : (sum - least_depth_sum(leaves)) / static_cast<double>(leaves);
}

double unevenness(const Tree& tree) {
  double sum = 0;
  double nodes = 0;
  for (const Node& node : tree.nodes) {
    if (!node.is_leaf()) {
      const double left = tree.nodes[node.left].count;
      const double right = tree.nodes[node.right].count;
      sum += (left > right ? left - right : right - left) / (left + right);
      ++nodes;
    } else if (node.undividable) {
      ++sum;
      ++nodes;
    }
  }
  return nodes > 0 ? sum / nodes : 0;
}

}  // namespace

BalanceMeasures balance_of(const Tree& tree, const BuildOptions& options) {
  const TreeStatistics counts = statistics(tree, options);
  return {.balanced_level = static_cast<double>(counts.balanced_level),
          .depth_spread = static_cast<double>(counts.max_leaf_depth - counts.min_leaf_depth),
          .depth_excess = depth_excess(tree, counts.leaves),
          .unevenness = unevenness(tree)};
}

}  // namespace soms::reproduce
