#include "thesis/trees/balance_measures.h"

#include "soms/tree/statistics.h"

namespace soms::reproduce {

namespace {

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
  return {.small_leaves = static_cast<double>(counts.lt5),
          .balanced_level = static_cast<double>(counts.balanced_level),
          .unevenness = unevenness(tree)};
}

}  // namespace soms::reproduce
