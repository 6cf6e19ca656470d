#include "soms/tree/build/detail/by_reference.h"

#include "soms/base/parallel.h"
#include "soms/tree/build/detail/cells.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace soms::detail {

namespace {

class ByReference {
 public:
  ByReference(const MeshView& mesh, const BuildOptions& options, const Limits& limits)
      : mesh_(mesh),
        options_(options),
        limits_(limits),
        last_depth_(options.level == 0
                        ? std::numeric_limits<std::uint32_t>::max()
                        : static_cast<std::uint32_t>(options.level - options.root_level)) {}

  Subtrees run() {
    Cells sorted = sort_into_cells(mesh_, limits_);
    subtrees_.ids.resize(mesh_.triangles.size());
    subtrees_.bounds = sorted.bounds;
    references_ = std::move(sorted.spare);
    divide_upper(sorted);
    gather(sorted);
    sorted = {};
    divide_large();
    build_subtrees();
    return std::move(subtrees_);
  }

 private:
  [[nodiscard]] bool is_leaf(std::uint32_t count, std::uint32_t depth) const {
    return count <= static_cast<std::uint32_t>(options_.per_leaf) || depth >= last_depth_;
  }

  /// From here on only halving ends at kMaxTreeIdDepth; a level limit ends before.
  [[nodiscard]] bool too_deep(std::uint32_t count, std::uint32_t depth) const {
    return options_.level == 0 &&
           depth + static_cast<std::uint32_t>(std::bit_width(count - 1)) >= kMaxTreeIdDepth;
  }

  void begin_subtree(std::uint32_t i, const PrimitiveRange& range) {
    subtrees_.upper[i].subtree = static_cast<std::uint32_t>(subtrees_.nodes.size());
    subtrees_.nodes.emplace_back();
    roots_.push_back({i, range});
  }

  /// Adds two children of upper node `i`; returns the place of the left one.
  std::uint32_t add_children(std::uint32_t i, std::uint32_t left_count) {
    const auto left = static_cast<std::uint32_t>(subtrees_.upper.size());
    const Node parent = subtrees_.upper[i].node;
    subtrees_.upper[i].node.left = left;
    subtrees_.upper[i].node.right = left + 1;
    subtrees_.upper.push_back({child_of(parent, false, parent.first, left_count)});
    subtrees_.upper.push_back(
        {child_of(parent, true, parent.first + left_count, parent.count - left_count)});
    return left;
  }

  struct PendingCells {
    std::uint32_t upper;
    std::size_t begin;
    std::size_t end;
  };

  /// The tree over whole cells, down to nodes of kSubtreeTriangles or of a single cell.
  void divide_upper(Cells& sorted) {
    Node root;
    root.id = 0;
    root.count = static_cast<std::uint32_t>(mesh_.triangles.size());
    subtrees_.upper.push_back({root});
    std::vector<PendingCells> pending{{0, 0, sorted.cells.size()}};
    while (!pending.empty()) {
      check(limits_);  // there may be as many cells as triangles
      const PendingCells next = pending.back();
      pending.pop_back();
      const Node node = subtrees_.upper[next.upper].node;
      const auto cells = std::span(sorted.cells).subspan(next.begin, next.end - next.begin);
      if (node.count <= kSubtreeTriangles || is_leaf(node.count, node.depth) || cells.size() == 1 ||
          too_deep(node.count, node.depth)) {
        whole_.push_back(next);
        continue;
      }
      const std::size_t left = divide_cells(cells);
      std::uint32_t left_count = 0;
      for (const Cell& cell : cells.first(left)) {
        left_count += cell.range.count;
      }
      const std::uint32_t child = add_children(next.upper, left_count);
      pending.push_back({child + 1, next.begin + left, next.end});
      pending.push_back({child, next.begin, next.begin + left});
    }
  }

  /// Copies the references of each node's cells to where its primitives are.
  void gather(const Cells& sorted) {
    ranges_.resize(whole_.size());
    for_each_chunk(whole_.size(), 1, {.threads = limits_.threads, .stop = limits_.stop},
                   [&](std::size_t k, std::size_t) {
                     const Node& node = subtrees_.upper[whole_[k].upper].node;
                     PrimitiveRange range;
                     range.first = node.first;
                     Reference* to = references_.data() + node.first;
                     for (std::size_t c = whole_[k].begin; c < whole_[k].end; ++c) {
                       const PrimitiveRange& cell = sorted.cells[c].range;
                       to = std::copy_n(sorted.references.data() + cell.first, cell.count, to);
                       range.count += cell.count;
                       range.middles.grow(cell.middles);
                       range.widest = lanes::max(range.widest, cell.widest);
                     }
                     ranges_[k] = range;
                   });
  }

  struct PendingRange {
    std::uint32_t upper;
    PrimitiveRange range;
  };

  /// Single cells may still hold more than a subtree.
  void divide_large() {
    ReferenceDivider divider(options_);
    std::vector<PendingRange> pending;
    for (std::size_t k = whole_.size(); k-- > 0;) {
      pending.push_back({whole_[k].upper, ranges_[k]});
    }
    while (!pending.empty()) {
      check(limits_);
      const PendingRange next = pending.back();
      pending.pop_back();
      const Node node = subtrees_.upper[next.upper].node;
      if (node.count <= kSubtreeTriangles || is_leaf(node.count, node.depth)) {
        begin_subtree(next.upper, next.range);
        continue;
      }
      const Halves halves = divide(divider, node.depth, next.range);
      subtrees_.upper[next.upper].node.undividable = halves.even;
      const std::uint32_t child = add_children(next.upper, halves.left.count);
      pending.push_back({child + 1, halves.right});
      pending.push_back({child, halves.left});
    }
  }

  Halves divide(ReferenceDivider& divider, std::uint32_t depth, const PrimitiveRange& range) {
    return too_deep(range.count, depth) ? ReferenceDivider::halve(references_, range)
                                        : divider.divide(references_, range);
  }

  void build_subtrees() {
    for_each_chunk(roots_.size(), 1, within(limits_, 0.3, 1), [&](std::size_t k, std::size_t) {
      const PendingRange& root = roots_[k];
      subtrees_.nodes[k] = build_subtree(subtrees_.upper[root.upper].node, root.range);
    });
  }

  /// A whole subtree in depth-first order; numbers count from its root.
  std::vector<PartNode> build_subtree(const Node& root, PrimitiveRange whole) {
    struct Pending {
      PrimitiveRange range;
      std::uint32_t depth;
      std::uint32_t right_of;  // parent, for right children
    };

    refine(whole);
    ReferenceDivider divider(options_);
    std::vector<PartNode> nodes;
    nodes.reserve(root.count / 2 + 1);
    std::vector<Pending> pending{{whole, root.depth, Node::kNone}};
    while (!pending.empty()) {
      const auto [range, depth, right_of] = pending.back();
      pending.pop_back();
      const auto i = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back({range.first, range.count, 0, false});
      if (right_of != Node::kNone) {
        nodes[right_of].right = i;
      }
      if (!is_leaf(range.count, depth)) {
        const Halves halves = divide(divider, depth, range);
        nodes[i].undividable = halves.even;
        pending.push_back({halves.right, depth + 1, i});
        pending.push_back({halves.left, depth + 1, Node::kNone});
      }
    }
    for (std::uint32_t k = root.first; k < root.first + root.count; ++k) {
      subtrees_.ids[k] = references_[k].id;
    }
    order_leaves(nodes, subtrees_.ids);
    return nodes;
  }

  /// References are rounded to 2^-24 of the mesh. A subtree much smaller than that gets new ones.
  void refine(PrimitiveRange& range) {
    constexpr float kFine = 0x1p-12F;
    const lanes::F4 extent = range.middles.upper - range.middles.lower;
    if (std::max({extent[0], extent[1], extent[2]}) > kFine) {
      return;
    }
    const auto run = std::span(references_).subspan(range.first, range.count);
    Box box;
    for (const Reference& r : run) {
      box.grow(bounds(mesh_.triangle(r.id)).center());
    }
    const PrimitiveFrame frame = frame_of(box);
    PrimitiveRange fresh;
    fresh.first = range.first;
    for (Reference& r : run) {
      r = reference_of(mesh_, r.id, frame);
      fresh.add(r);
    }
    range = fresh;
  }

  MeshView mesh_;
  const BuildOptions& options_;
  const Limits& limits_;
  std::uint32_t last_depth_;  // nodes of this depth are never divided
  layout::Pages<Reference> references_;
  std::vector<PendingCells> whole_;     // upper nodes whose cells are divided no more
  std::vector<PrimitiveRange> ranges_;  // and their references
  std::vector<PendingRange> roots_;     // of the subtrees
  Subtrees subtrees_;
};

}  // namespace

Subtrees grow_by_reference(const MeshView& mesh, const BuildOptions& options,
                           const Limits& limits) {
  return ByReference(mesh, options, limits).run();
}

}  // namespace soms::detail
