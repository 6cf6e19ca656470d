#include "soms/tree/build/detail/by_reference.h"

#include "soms/tree/build/detail/cells.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace soms::detail {

namespace {

class ByReference {
 public:
  ByReference(const Mesh& mesh, const BuildOptions& options, const Parallel& parallel)
      : mesh_(mesh),
        options_(options),
        parallel_(parallel),
        last_depth_(options.level == 0
                        ? std::numeric_limits<std::uint32_t>::max()
                        : static_cast<std::uint32_t>(options.level - options.root_level)) {}

  Forest run() {
    Cells sorted = sort_into_cells(mesh_, parallel_);
    forest_.ids.resize(mesh_.triangles.size());
    forest_.bounds = sorted.bounds;
    references_ = std::move(sorted.spare);
    divide_upper(sorted);
    gather(sorted);
    sorted = {};
    divide_large();
    build_subtrees();
    return std::move(forest_);
  }

 private:
  [[nodiscard]] bool is_leaf(const Node& node) const {
    return node.count <= static_cast<std::uint32_t>(options_.per_leaf) || node.depth >= last_depth_;
  }

  /// From here on only halving ends at kMaxTreeIdDepth; a level limit ends before.
  [[nodiscard]] bool too_deep(const Node& node) const {
    return options_.level == 0 &&
           node.depth + static_cast<std::uint32_t>(std::bit_width(node.count - 1)) >=
               kMaxTreeIdDepth;
  }

  void begin_subtree(std::uint32_t i, const Crowd& crowd) {
    forest_.upper[i].subtree = static_cast<std::uint32_t>(forest_.subtrees.size());
    forest_.subtrees.emplace_back();
    roots_.push_back({i, crowd});
  }

  /// Adds two children of upper node `i`; returns the place of the left one.
  std::uint32_t add_children(std::uint32_t i, std::uint32_t left_count) {
    const auto left = static_cast<std::uint32_t>(forest_.upper.size());
    const Node parent = forest_.upper[i].node;
    forest_.upper[i].node.left = left;
    forest_.upper[i].node.right = left + 1;
    forest_.upper.push_back({child_of(parent, false, parent.first, left_count)});
    forest_.upper.push_back(
        {child_of(parent, true, parent.first + left_count, parent.count - left_count)});
    return left;
  }

  struct OpenCells {
    std::uint32_t upper;
    std::size_t begin;
    std::size_t end;
  };

  /// The tree over whole cells, down to nodes of kSubtreeTriangles or of a single cell.
  void divide_upper(Cells& sorted) {
    Node root;
    root.id = 0;
    root.count = static_cast<std::uint32_t>(mesh_.triangles.size());
    forest_.upper.push_back({root});
    std::vector<OpenCells> open{{0, 0, sorted.cells.size()}};
    while (!open.empty()) {
      check_stop(parallel_);  // there may be as many cells as triangles
      const OpenCells next = open.back();
      open.pop_back();
      const Node node = forest_.upper[next.upper].node;
      const auto cells = std::span(sorted.cells).subspan(next.begin, next.end - next.begin);
      if (node.count <= kSubtreeTriangles || is_leaf(node) || cells.size() == 1 || too_deep(node)) {
        whole_.push_back(next);
        continue;
      }
      const std::size_t left = divide_cells(cells);
      std::uint32_t left_count = 0;
      for (const Cell& cell : cells.first(left)) {
        left_count += cell.crowd.count;
      }
      const std::uint32_t child = add_children(next.upper, left_count);
      open.push_back({child + 1, next.begin + left, next.end});
      open.push_back({child, next.begin, next.begin + left});
    }
  }

  /// Copies the references of each node's cells to where its primitives are.
  void gather(const Cells& sorted) {
    crowds_.resize(whole_.size());
    for_each_chunk(whole_.size(), 1, {parallel_.threads, parallel_.stop, {}},
                   [&](std::size_t k, std::size_t) {
                     const Node& node = forest_.upper[whole_[k].upper].node;
                     Crowd crowd;
                     crowd.first = node.first;
                     Reference* to = references_.data() + node.first;
                     for (std::size_t c = whole_[k].begin; c < whole_[k].end; ++c) {
                       const Crowd& cell = sorted.cells[c].crowd;
                       to = std::copy_n(sorted.references.data() + cell.first, cell.count, to);
                       crowd.count += cell.count;
                       crowd.middles.grow(cell.middles);
                       crowd.widest = lanes::max(crowd.widest, cell.widest);
                     }
                     crowds_[k] = crowd;
                   });
  }

  struct OpenCrowd {
    std::uint32_t upper;
    Crowd crowd;
  };

  /// Single cells may still hold more than a subtree.
  void divide_large() {
    ReferenceDivider divider(options_);
    std::vector<OpenCrowd> open;
    for (std::size_t k = whole_.size(); k-- > 0;) {
      open.push_back({whole_[k].upper, crowds_[k]});
    }
    while (!open.empty()) {
      check_stop(parallel_);
      const OpenCrowd next = open.back();
      open.pop_back();
      const Node node = forest_.upper[next.upper].node;
      if (node.count <= kSubtreeTriangles || is_leaf(node)) {
        begin_subtree(next.upper, next.crowd);
        continue;
      }
      const Halves halves = divide(divider, node, next.crowd);
      forest_.upper[next.upper].node.undividable = halves.even;
      const std::uint32_t child = add_children(next.upper, halves.left.count);
      open.push_back({child + 1, halves.right});
      open.push_back({child, halves.left});
    }
  }

  Halves divide(ReferenceDivider& divider, const Node& node, const Crowd& crowd) {
    return too_deep(node) ? ReferenceDivider::halve(references_, crowd)
                          : divider.divide(references_, crowd);
  }

  void build_subtrees() {
    for_each_chunk(roots_.size(), 1, within(parallel_, 0.3, 1), [&](std::size_t k, std::size_t) {
      const OpenCrowd& root = roots_[k];
      forest_.subtrees[k] = build_subtree(forest_.upper[root.upper].node, root.crowd);
    });
  }

  /// A whole subtree in depth-first order; indices count from its root.
  std::vector<Node> build_subtree(const Node& root, Crowd whole) {
    struct Open {
      Node node;
      Crowd crowd;
      std::uint32_t right_of;  // parent, for right children
    };

    refine(whole);
    ReferenceDivider divider(options_);
    std::vector<Node> nodes;
    nodes.reserve(root.count / 2);
    std::vector<Open> open{{root, whole, Node::kNone}};
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      const auto i = static_cast<std::uint32_t>(nodes.size());
      Node& node = nodes.emplace_back(next.node);
      if (!is_leaf(node)) {
        const Halves halves = divide(divider, node, next.crowd);
        node.undividable = halves.even;
        node.left = i + 1;
        open.push_back(
            {child_of(node, true, halves.right.first, halves.right.count), halves.right, i});
        open.push_back({child_of(node, false, halves.left.first, halves.left.count), halves.left,
                        Node::kNone});
      }
      if (next.right_of != Node::kNone) {
        nodes[next.right_of].right = i;
      }
    }
    for (std::uint32_t k = root.first; k < root.first + root.count; ++k) {
      forest_.ids[k] = references_[k].id;
    }
    return nodes;
  }

  /// References are rounded to 2^-24 of the mesh. A subtree much smaller than that gets new ones.
  void refine(Crowd& crowd) {
    constexpr float kFine = 0x1p-12F;
    const lanes::F4 extent = crowd.middles.upper - crowd.middles.lower;
    if (std::max({extent[0], extent[1], extent[2]}) > kFine) {
      return;
    }
    const auto run = std::span(references_).subspan(crowd.first, crowd.count);
    Box box;
    for (const Reference& r : run) {
      box.grow(bounds(mesh_.triangle(r.id)).center());
    }
    const ReferenceFrame frame = frame_of(box);
    Crowd fresh;
    fresh.first = crowd.first;
    for (Reference& r : run) {
      r = reference_of(mesh_, r.id, frame);
      fresh.add(r);
    }
    crowd = fresh;
  }

  const Mesh& mesh_;
  const BuildOptions& options_;
  const Parallel& parallel_;
  std::uint32_t last_depth_;  // nodes of this depth are never divided
  layout::Pages<Reference> references_;
  std::vector<OpenCells> whole_;  // upper nodes whose cells are divided no more
  std::vector<Crowd> crowds_;     // and their references
  std::vector<OpenCrowd> roots_;  // of the subtrees
  Forest forest_;
};

}  // namespace

Forest grow_by_reference(const Mesh& mesh, const BuildOptions& options, const Parallel& parallel) {
  return ByReference(mesh, options, parallel).run();
}

}  // namespace soms::detail
