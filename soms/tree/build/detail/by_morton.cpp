#include "soms/tree/build/detail/by_morton.h"

#include "soms/base/parallel.h"
#include "soms/tree/build/detail/morton.h"
#include "soms/tree/layout/detail/refit_layout.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace soms::detail {

namespace {

/// Nodes of at most so many leaves' triangles are cut into full leaves.
constexpr std::uint64_t kFullLeaves = 4;

class ByMorton {
 public:
  ByMorton(const MeshView& mesh, const BuildOptions& options, const Limits& limits)
      : mesh_(mesh),
        limits_(limits),
        id_bits_(id_bits_for(mesh.triangles.size())),
        per_leaf_(static_cast<std::uint32_t>(options.per_leaf)),
        limited_(options.level != 0),
        last_depth_(limited_ ? static_cast<std::uint32_t>(options.level - options.root_level)
                             : std::numeric_limits<std::uint32_t>::max()) {}

  Subtrees run() {
    const Limits silent = limits_.silent();
    subtrees_.bounds = layout::bounds_of(mesh_, silent);
    keys_ = sorted_keys(mesh_, subtrees_.bounds, silent);
    subtrees_.ids.resize(keys_.size());
    divide_upper();
    build_subtrees();
    return std::move(subtrees_);
  }

 private:
  /// The keys of a node.
  struct Run {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t depth = 0;

    [[nodiscard]] Run left(std::uint32_t n) const { return {first, n, depth + 1}; }

    [[nodiscard]] Run right(std::uint32_t left) const {
      return {first + left, count - left, depth + 1};
    }
  };

  /// A node to be divided; `even` if its middles are one, so that only halving is left.
  struct Pending {
    Run run;
    bool even;
    std::uint32_t place;  // of an upper node, or of the parent of a right child
  };

  [[nodiscard]] bool is_leaf(const Run& node) const {
    return node.count <= per_leaf_ || node.depth >= last_depth_;
  }

  /// From here on only halving ends at kMaxTreeIdDepth; a level limit ends before.
  [[nodiscard]] bool too_deep(const Run& node) const {
    return !limited_ && node.depth + static_cast<std::uint32_t>(std::bit_width(node.count - 1)) >=
                            kMaxTreeIdDepth;
  }

  /// Triangles of the left child. Keys that are all one get new codes first.
  [[nodiscard]] std::uint32_t divide(const Run& node, bool& even) {
    const auto run = std::span(keys_).subspan(node.first, node.count);
    if (even || too_deep(node)) {
      return node.count / 2;
    }
    if ((run.front() ^ run.back()) >> id_bits_ == 0 && !refine_keys(mesh_, run, id_bits_)) {
      even = true;
      return node.count / 2;
    }
    return node.count <= kFullLeaves * per_leaf_ ? full_leaves(run) : first_of_right(run);
  }

  /// Where the highest bit in which the run's codes differ is set.
  [[nodiscard]] static std::uint32_t first_of_right(std::span<const MortonKey> run) {
    const int bit = static_cast<int>(std::bit_width(run.front() ^ run.back())) - 1;
    const auto* const at =
        std::partition_point(run.data(), run.data() + run.size(),
                             [bit](MortonKey key) { return (key >> bit & 1) == 0; });
    return static_cast<std::uint32_t>(at - run.data());
  }

  /// The widest gap of those that leave no more leaves than there must be. A leaf that is not full
  /// costs as much as one that is, to make and to query.
  [[nodiscard]] std::uint32_t full_leaves(std::span<const MortonKey> run) const {
    const auto count = static_cast<std::uint32_t>(run.size());
    const std::uint32_t leaves = (count + per_leaf_ - 1) / per_leaf_;
    const std::uint32_t room = leaves * per_leaf_ - count;
    std::uint32_t best = per_leaf_;
    MortonKey widest = 0;
    for (std::uint32_t full = per_leaf_; full < count; full += per_leaf_) {
      for (std::uint32_t left = full - room; left <= full; ++left) {
        const MortonKey gap = run[left - 1] ^ run[left];
        if (gap > widest) {
          widest = gap;
          best = left;
        }
      }
    }
    return best;
  }

  void divide_upper() {
    Node root;
    root.id = 0;
    root.count = static_cast<std::uint32_t>(keys_.size());
    subtrees_.upper.push_back({root});
    std::vector<Pending> pending{{{0, root.count, 0}, false, 0}};
    while (!pending.empty()) {
      check(limits_);
      Pending next = pending.back();
      pending.pop_back();
      if (next.run.count <= kSubtreeTriangles || is_leaf(next.run)) {
        subtrees_.upper[next.place].subtree = static_cast<std::uint32_t>(roots_.size());
        roots_.push_back(next);
        continue;
      }
      const std::uint32_t count = divide(next.run, next.even);
      const auto left = static_cast<std::uint32_t>(subtrees_.upper.size());
      Node& node = subtrees_.upper[next.place].node;
      node.undividable = next.even;
      node.left = left;
      node.right = left + 1;
      const Node parent = node;
      for (const bool right : {false, true}) {
        const Run run = right ? next.run.right(count) : next.run.left(count);
        subtrees_.upper.push_back({child_of(parent, right, run.first, run.count)});
        pending.push_back({run, next.even, left + (right ? 1 : 0)});
      }
    }
  }

  void build_subtrees() {
    subtrees_.nodes.resize(roots_.size());
    for_each_chunk(roots_.size(), 1, within(limits_, 0.3, 1), [&](std::size_t k, std::size_t) {
      subtrees_.nodes[k] = build_subtree(roots_[k]);
    });
  }

  /// A whole subtree in depth-first order; numbers count from its root.
  std::vector<PartNode> build_subtree(const Pending& root) {
    std::vector<PartNode> nodes;
    nodes.reserve(root.run.count / 2 + 1);
    std::vector<Pending> pending{{root.run, root.even, Node::kNone}};
    while (!pending.empty()) {
      Pending next = pending.back();
      pending.pop_back();
      const auto i = static_cast<std::uint32_t>(nodes.size());
      const bool leaf = is_leaf(next.run);
      const std::uint32_t count = leaf ? 0 : divide(next.run, next.even);
      nodes.push_back({next.run.first, next.run.count, 0, !leaf && next.even});
      if (next.place != Node::kNone) {
        nodes[next.place].right = i;
      }
      if (!leaf) {
        pending.push_back({next.run.right(count), next.even, i});
        pending.push_back({next.run.left(count), next.even, Node::kNone});
      }
    }
    const MortonKey ids = (MortonKey{1} << id_bits_) - 1;
    for (std::uint32_t k = root.run.first; k < root.run.first + root.run.count; ++k) {
      subtrees_.ids[k] = static_cast<TriangleId>(keys_[k] & ids);
    }
    order_leaves(nodes, subtrees_.ids);
    return nodes;
  }

  MeshView mesh_;
  const Limits& limits_;
  int id_bits_;
  std::uint32_t per_leaf_;
  bool limited_;
  std::uint32_t last_depth_;  // nodes of this depth are never divided
  layout::Pages<MortonKey> keys_;
  std::vector<Pending> roots_;  // of the subtrees
  Subtrees subtrees_;
};

}  // namespace

Subtrees grow_by_morton(const MeshView& mesh, const BuildOptions& options, const Limits& limits) {
  return ByMorton(mesh, options, limits).run();
}

}  // namespace soms::detail
