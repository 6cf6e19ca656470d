#include "soms/tree/layout/detail/parts.h"

#include <utility>

namespace soms::layout {

Cut cut(const Tree& tree) {
  Cut result;
  const std::span<const Node> nodes(tree.nodes);

  struct Pending {
    std::uint32_t binary;
    std::uint32_t upper;
    std::uint32_t end;  // nodes of this one and below lie before it
  };

  std::vector<Pending> pending{{0, 0, static_cast<std::uint32_t>(nodes.size())}};
  result.upper.emplace_back();
  while (!pending.empty()) {
    const Pending next = pending.back();
    pending.pop_back();
    const Node& node = nodes[next.binary];
    UpperNode upper{node.count, Node::kNone, Node::kNone, Node::kNone};
    if (node.count <= kPartTriangles || node.is_leaf()) {
      upper.part = static_cast<std::uint32_t>(result.parts.size());
      result.parts.push_back({next.binary, next.end});
    } else {
      upper.left = static_cast<std::uint32_t>(result.upper.size());
      upper.right = upper.left + 1;
      pending.push_back({node.right, upper.right, next.end});
      pending.push_back({node.left, upper.left, node.right});
      result.upper.resize(result.upper.size() + 2);
    }
    result.upper[next.upper] = upper;
  }
  return result;
}

Parts parts_of(const Tree& tree) {
  Cut where = cut(tree);
  Parts result;
  result.bounds = tree.nodes.front().bounds;
  result.primitives = tree.primitives;
  result.upper = std::move(where.upper);
  result.nodes.reserve(where.parts.size());
  for (const Cut::Range& range : where.parts) {
    std::vector<PartNode>& nodes = result.nodes.emplace_back();
    nodes.reserve(range.end - range.begin);
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const Node& node = tree.nodes[i];
      nodes.push_back({node.first, node.count, node.is_leaf() ? 0 : node.right - range.begin,
                       node.undividable});
    }
  }
  return result;
}

}  // namespace soms::layout
