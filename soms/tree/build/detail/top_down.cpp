#include "soms/tree/build/detail/top_down.h"

#include "soms/base/parallel.h"
#include "soms/tree/build/detail/divide.h"
#include "soms/tree/layout/detail/pages.h"
#include "soms/tree/layout/detail/refit_layout.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace soms::detail {

namespace {

/// Triangles that one chunk of the first pass prepares.
constexpr std::size_t kPrepareChunk = 16384;

class Builder {
 public:
  Builder(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options,
          const Limits& limits)
      : mesh_(mesh), limits_(limits), divider_(mesh, rule, options) {}

  Subtrees run() {
    prepare();
    divide_upper();
    build_subtrees();
    subtrees_.bounds = layout::bounds_of(mesh_, limits_);
    return std::move(subtrees_);
  }

 private:
  void prepare() {
    primitives_.resize(mesh_.triangles.size());
    subtrees_.ids.resize(primitives_.size());
    std::vector<Box> inner((primitives_.size() - 1) / kPrepareChunk + 1);
    for_each_chunk(primitives_.size(), kPrepareChunk, within(limits_, 0, 0.05),
                   [&](std::size_t begin, std::size_t end) {
                     inner[begin / kPrepareChunk] = divider_.prepare(begin, end, primitives_);
                   });
    for (const Box& box : inner) {
      inner_.grow(box);
    }
  }

  Division divide(const Node& node, const Box& inner) {
    return divider_.divide(std::span(primitives_).subspan(node.first, node.count), inner,
                           node.depth);
  }

  /// Divides all nodes of more than kSubtreeTriangles, one depth after the other.
  void divide_upper() {
    Node root;
    root.id = 0;
    root.count = static_cast<std::uint32_t>(primitives_.size());
    subtrees_.upper.push_back({root});
    inner_of_.push_back(inner_);
    std::vector<std::uint32_t> wave{0};
    while (!wave.empty()) {
      std::erase_if(wave, [&](std::uint32_t i) { return make_subtree(i); });
      std::vector<Division> divisions(wave.size());
      for_each_chunk(wave.size(), 1, limits_.silent(), [&](std::size_t k, std::size_t) {
        divisions[k] = divide(subtrees_.upper[wave[k]].node, inner_of_[wave[k]]);
      });
      std::vector<std::uint32_t> next;
      for (std::size_t k = 0; k < wave.size(); ++k) {
        attach(wave[k], divisions[k], next);
      }
      wave = std::move(next);
    }
  }

  /// True if upper node `i` is small enough to be built whole by one thread.
  bool make_subtree(std::uint32_t i) {
    if (subtrees_.upper[i].node.count > kSubtreeTriangles) {
      return false;
    }
    begin_subtree(i);
    return true;
  }

  void begin_subtree(std::uint32_t i) {
    subtrees_.upper[i].subtree = static_cast<std::uint32_t>(subtrees_.nodes.size());
    subtrees_.nodes.emplace_back();
  }

  void attach(std::uint32_t i, const Division& division, std::vector<std::uint32_t>& next) {
    if (!division.divided) {
      begin_subtree(i);  // of one node
      return;
    }
    Node& node = subtrees_.upper[i].node;
    node.undividable = division.undividable;
    node.left = static_cast<std::uint32_t>(subtrees_.upper.size());
    node.right = node.left + 1;
    const Node left = child_of(node, false, node.first, division.left_count);
    const Node right =
        child_of(node, true, node.first + division.left_count, node.count - division.left_count);
    next.push_back(node.left);
    next.push_back(node.right);
    subtrees_.upper.push_back({left});
    subtrees_.upper.push_back({right});
    inner_of_.push_back(division.left_inner);
    inner_of_.push_back(division.right_inner);
  }

  void build_subtrees() {
    std::vector<std::uint32_t> roots(subtrees_.nodes.size());
    for (std::uint32_t i = 0; i < subtrees_.upper.size(); ++i) {
      if (subtrees_.upper[i].subtree != Node::kNone) {
        roots[subtrees_.upper[i].subtree] = i;
      }
    }
    for_each_chunk(roots.size(), 1, within(limits_, 0.4, 0.95), [&](std::size_t k, std::size_t) {
      subtrees_.nodes[k] = build_subtree(subtrees_.upper[roots[k]].node, inner_of_[roots[k]]);
    });
  }

  /// A whole subtree in depth-first order; numbers count from its root.
  std::vector<PartNode> build_subtree(const Node& root, const Box& root_inner) {
    std::vector<PartNode> nodes;

    struct Pending {
      Node node;
      Box inner;
      std::uint32_t right_of;  ///< parent, for right children
    };

    std::vector<Pending> pending{{root, root_inner, Node::kNone}};
    while (!pending.empty()) {
      const auto [node, inner, right_of] = pending.back();
      pending.pop_back();
      const auto i = static_cast<std::uint32_t>(nodes.size());
      const Division division = divide(node, inner);
      nodes.push_back({node.first, node.count, 0, division.undividable});
      if (division.divided) {
        const std::uint32_t count = division.left_count;
        pending.push_back({child_of(node, true, node.first + count, node.count - count),
                           division.right_inner, i});
        pending.push_back(
            {child_of(node, false, node.first, count), division.left_inner, Node::kNone});
      }
      if (right_of != Node::kNone) {
        nodes[right_of].right = i;
      }
    }
    const auto run = std::span(primitives_).subspan(root.first, root.count);
    std::transform(run.begin(), run.end(), subtrees_.ids.begin() + root.first,
                   [](const Primitive& p) { return p.id; });
    order_leaves(nodes, subtrees_.ids);
    return nodes;
  }

  MeshView mesh_;
  const Limits& limits_;
  Divider divider_;
  layout::Pages<Primitive> primitives_;
  Box inner_;                  ///< bounds of all midpoints
  std::vector<Box> inner_of_;  ///< the same for each upper node
  Subtrees subtrees_;
};

}  // namespace

Subtrees grow_top_down(const MeshView& mesh, const RuleEntry& rule, const BuildOptions& options,
                       const Limits& limits) {
  return Builder(mesh, rule, options, limits).run();
}

}  // namespace soms::detail
