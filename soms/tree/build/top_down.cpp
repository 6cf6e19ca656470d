#include "soms/tree/build.h"
#include "soms/tree/build/detail/divide.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace soms {

namespace {

/// Nodes with more triangles are divided wave by wave, nodes in parallel; the others become
/// subtrees, each built by one thread. A constant, so that it cannot depend on the threads.
constexpr std::uint32_t kSubtreeTriangles = 8192;

/// Triangles that one chunk of the first pass prepares.
constexpr std::size_t kPrepareChunk = 16384;

/// A node of the upper tree, above and including the roots of the subtrees.
struct Upper {
  Node node;
  Box inner;                            ///< bounds of the midpoints
  std::uint32_t subtree = Node::kNone;  ///< number of the subtree below, or kNone
};

/// `parallel` with progress mapped to a part of the whole.
Parallel within(const Parallel& parallel, double from, double to) {
  Parallel part{parallel.threads, parallel.stop, {}};
  if (parallel.progress) {
    part.progress = [&parallel, from, to](double share) {
      parallel.progress(from + (to - from) * share);
    };
  }
  return part;
}

Node child(const Node& parent, bool right, std::uint32_t first, std::uint32_t count) {
  Node node;
  node.id = right ? right_child_of(parent.id) : left_child_of(parent.id);
  node.first = first;
  node.count = count;
  node.depth = parent.depth + 1;
  return node;
}

class Builder {
 public:
  Builder(const Mesh& mesh, const BuildOptions& options, const Parallel& parallel)
      : mesh_(mesh), parallel_(parallel), divider_(mesh, options) {}

  Tree run() {
    prepare();
    divide_upper();
    build_subtrees();
    return join();
  }

 private:
  void prepare() {
    primitives_.resize(mesh_.triangles.size());
    ids_.resize(primitives_.size());
    std::vector<Box> inner((primitives_.size() - 1) / kPrepareChunk + 1);
    for_each_chunk(primitives_.size(), kPrepareChunk, within(parallel_, 0, 0.05),
                   [&](std::size_t begin, std::size_t end) {
                     inner[begin / kPrepareChunk] = divider_.prepare(begin, end, primitives_);
                   });
    for (const Box& box : inner) {
      inner_.grow(box);
    }
  }

  detail::Division divide(const Node& node, const Box& inner) {
    return divider_.divide(std::span(primitives_).subspan(node.first, node.count), inner,
                           node.depth);
  }

  /// Divides all nodes of more than kSubtreeTriangles, one depth after the other.
  void divide_upper() {
    Node root;
    root.id = 0;
    root.count = static_cast<std::uint32_t>(primitives_.size());
    upper_.push_back({root, inner_});
    std::vector<std::uint32_t> wave{0};
    while (!wave.empty()) {
      std::erase_if(wave, [&](std::uint32_t i) { return make_subtree(i); });
      std::vector<detail::Division> divisions(wave.size());
      for_each_chunk(wave.size(), 1, Parallel{parallel_.threads, parallel_.stop, {}},
                     [&](std::size_t k, std::size_t) {
                       divisions[k] = divide(upper_[wave[k]].node, upper_[wave[k]].inner);
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
    if (upper_[i].node.count > kSubtreeTriangles) {
      return false;
    }
    upper_[i].subtree = static_cast<std::uint32_t>(subtrees_.size());
    subtrees_.emplace_back();
    return true;
  }

  void attach(std::uint32_t i, const detail::Division& division, std::vector<std::uint32_t>& next) {
    Node& node = upper_[i].node;
    node.undividable = division.undividable;
    if (!division.divided) {
      return;
    }
    node.left = static_cast<std::uint32_t>(upper_.size());
    node.right = node.left + 1;
    const Node left = child(node, false, node.first, division.left_count);
    const Node right =
        child(node, true, node.first + division.left_count, node.count - division.left_count);
    next.push_back(node.left);
    next.push_back(node.right);
    upper_.push_back({left, division.left_inner});
    upper_.push_back({right, division.right_inner});
  }

  void build_subtrees() {
    std::vector<const Upper*> roots(subtrees_.size());
    for (const Upper& upper : upper_) {
      if (upper.subtree != Node::kNone) {
        roots[upper.subtree] = &upper;
      }
    }
    for_each_chunk(subtrees_.size(), 1, within(parallel_, 0.4, 0.95),
                   [&](std::size_t k, std::size_t) { subtrees_[k] = build_subtree(*roots[k]); });
  }

  /// A whole subtree in depth-first order; indices count from its root.
  std::vector<Node> build_subtree(const Upper& root) {
    std::vector<Node> nodes;

    struct Open {
      Node node;
      Box inner;
      std::uint32_t right_of;  ///< parent, for right children
    };

    std::vector<Open> open{{root.node, root.inner, Node::kNone}};
    while (!open.empty()) {
      const auto [start, inner, right_of] = open.back();
      open.pop_back();
      const auto i = static_cast<std::uint32_t>(nodes.size());
      Node& node = nodes.emplace_back(start);
      const detail::Division division = divide(node, inner);
      node.undividable = division.undividable;
      if (division.divided) {
        const std::uint32_t count = division.left_count;
        open.push_back(
            {child(node, true, node.first + count, node.count - count), division.right_inner, i});
        open.push_back({child(node, false, node.first, count), division.left_inner, Node::kNone});
        node.left = i + 1;
      }
      if (right_of != Node::kNone) {
        nodes[right_of].right = i;
      }
    }
    find_bounds(nodes);
    return nodes;
  }

  /// Children follow their parents, so the last node comes first.
  void find_bounds(std::vector<Node>& nodes) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
      Node& node = nodes[i];
      if (node.is_leaf()) {
        bound_leaf(node);
      } else {
        node.bounds = nodes[node.left].bounds;
        node.bounds.grow(nodes[node.right].bounds);
      }
    }
  }

  void bound_leaf(Node& node) {
    const auto run = std::span(primitives_).subspan(node.first, node.count);
    const auto ids = std::span(ids_).subspan(node.first, node.count);
    std::transform(run.begin(), run.end(), ids.begin(), [](const Primitive& p) { return p.id; });
    if (!std::is_sorted(ids.begin(), ids.end())) {
      std::sort(ids.begin(), ids.end());
    }
    for (const TriangleId id : ids) {
      node.bounds.grow(bounds(mesh_.triangle(id)));
    }
  }

  /// Upper tree and subtrees in depth-first order.
  Tree join() {
    Tree tree;
    std::vector<std::uint32_t> place(upper_.size());
    std::uint32_t size = 0;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      const Upper& upper = upper_[i];
      open.pop_back();
      place[i] = size;
      if (upper.subtree != Node::kNone) {
        size += static_cast<std::uint32_t>(subtrees_[upper.subtree].size());
      } else {
        ++size;
      }
      if (!upper.node.is_leaf()) {
        open.push_back(upper.node.right);
        open.push_back(upper.node.left);
      }
    }
    tree.nodes.resize(size);
    for_each_chunk(upper_.size(), 64, Parallel{parallel_.threads, parallel_.stop, {}},
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i) {
                       copy(upper_[i], place, place[i], tree);
                     }
                   });
    bound_upper(place, tree);
    tree.primitives = std::move(ids_);
    if (parallel_.progress) {
      parallel_.progress(1);
    }
    return tree;
  }

  void copy(const Upper& upper, const std::vector<std::uint32_t>& place, std::uint32_t at,
            Tree& tree) {
    if (upper.subtree == Node::kNone) {
      Node& node = tree.nodes[at];
      node = upper.node;
      if (!node.is_leaf()) {
        node.left = place[node.left];
        node.right = place[node.right];
      }
      return;
    }
    std::vector<Node>& nodes = subtrees_[upper.subtree];
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      Node& node = tree.nodes[at + k];
      node = nodes[k];
      if (!node.is_leaf()) {
        node.left += at;
        node.right += at;
      }
    }
    nodes = {};
  }

  void bound_upper(const std::vector<std::uint32_t>& place, Tree& tree) {
    for (std::size_t i = upper_.size(); i-- > 0;) {
      if (upper_[i].subtree != Node::kNone) {
        continue;
      }
      Node& node = tree.nodes[place[i]];
      if (node.is_leaf()) {
        bound_leaf(node);
      } else {
        node.bounds = tree.nodes[node.left].bounds;
        node.bounds.grow(tree.nodes[node.right].bounds);
      }
    }
  }

  const Mesh& mesh_;
  const Parallel& parallel_;
  detail::Divider divider_;
  std::vector<Primitive> primitives_;
  std::vector<TriangleId> ids_;  ///< of each leaf in ascending order, once it is bounded
  Box inner_;                    ///< bounds of all midpoints
  std::vector<Upper> upper_;
  std::vector<std::vector<Node>> subtrees_;
};

}  // namespace

Tree build(const Mesh& mesh, const BuildOptions& options, const Parallel& parallel) {
  check(options);
  check_stop(parallel);
  if (mesh.triangles.empty()) {
    return {};
  }
  return Builder(mesh, options, parallel).run();
}

}  // namespace soms
