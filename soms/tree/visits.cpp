#include "soms/tree/visits.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"

#include <cmath>
#include <string>
#include <vector>

namespace soms {

namespace {

void check_size(const Vec3& size) {
  for (const double s : {size.x, size.y, size.z}) {
    if (!(s >= 0) || !std::isfinite(s)) {
      throw Error(ErrorKind::usage, "expected visits: a side of " + std::to_string(s),
                  "use finite sides of 0 or more");
    }
  }
}

/// Probability that a random box overlaps `node`, given that it overlaps `root`. A factor an axis,
/// so that volumes cannot overflow.
double share(const Box& node, const Box& root, const Vec3& size) {
  const Vec3 of = node.extent();
  const Vec3 whole = root.extent();
  double product = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double range = whole[k] + size[k];
    product *= range > 0 ? (of[k] + size[k]) / range : 1;
  }
  return product;
}

}  // namespace

Visits count_visits(const Tree& tree, const Box& query) {
  const PlainArithmetic plain;
  Visits visits;
  std::vector<std::uint32_t> pending;
  if (!tree.nodes.empty()) {
    pending.push_back(0);
  }
  while (!pending.empty()) {
    const Node& node = tree.nodes[pending.back()];
    pending.pop_back();
    if (!overlaps(node.bounds, query)) {
      continue;
    }
    ++visits.nodes;
    if (node.is_leaf()) {
      ++visits.leaves;
      visits.triangles += node.count;
    } else {
      pending.push_back(node.right);
      pending.push_back(node.left);
    }
  }
  return visits;
}

ExpectedVisits expected_visits(const Tree& tree, const Vec3& size) {
  const PlainArithmetic plain;
  check_size(size);
  ExpectedVisits expected;
  for (const Node& node : tree.nodes) {
    if (node.bounds.empty()) {
      continue;
    }
    const double p = share(node.bounds, tree.nodes[0].bounds, size);
    expected.nodes += p;
    if (node.is_leaf()) {
      expected.leaves += p;
      expected.triangles += p * node.count;
    }
  }
  return expected;
}

}  // namespace soms
