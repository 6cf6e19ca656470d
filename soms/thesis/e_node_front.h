/// \file
/// E-Node that starts each frame where the last one ended.
#pragma once

#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/traversal_options.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace soms {

namespace detail {
class Probe;
}  // namespace detail

/// E-Node for two trees that move little from frame to frame.
///
/// Keeps the front of the last frame: the pairs where the descent ended, apart or two leaves. Every
/// pair of leaves lies below exactly one of them, so a frame that starts from all of them misses
/// nothing, wherever the trees went. Pairs that overlap are entered; where all child pairs of a
/// pair are apart and so is the pair, it takes their place (one level a frame). The first frame
/// starts at the roots. Reports come in another order than from the roots; the set is the same.
///
/// \threads One caller at a time.
/// \source  thesis, fig. 5.9 by its caption; Li and Chen 1998 for incremental traversals.
class EnodeFront {
 public:
  /// Trees must outlive the object.
  /// \errors ErrorKind::usage unless `descent` is both or larger: what the others descend depends
  ///         on where the trees are, so a front of theirs could not be traversed upward.
  EnodeFront(const Tree& a, const Tree& b, Descent descent = Descent::larger,
             EntryOrder order = EntryOrder::tree);

  /// The next frame: reports overlapping pairs of leaves, as `traverse` does.
  ///
  /// When the visitor stops or throws, later frames are still right: the front then holds pairs
  /// that were not entered.
  /// \shape  `boxes_a`, `boxes_b`: one world box a node of each tree.
  /// \errors ErrorKind::usage for another number of boxes.
  TraversalCounts next(std::span<const Box> boxes_a, std::span<const Box> boxes_b,
                       const TraversalVisitor& visitor = {});

  /// The front after the last frame; one pair, the roots, before the first. Empty with an empty
  /// tree.
  [[nodiscard]] std::span<const NodePair> front() const { return front_; }

  /// Forgets the last frame: the next one starts at the roots.
  void restart();

 private:
  /// Pairs of the last front that are apart, gathered by the pair they came from.
  struct Family {
    NodePair parent;
    std::array<NodePair, 4> apart{};
    std::size_t count = 0;
  };

  /// Families by parent, in order of first appearance; the memory stays from frame to frame.
  class Families {
   public:
    void clear(std::size_t most);
    void add(NodePair parent, NodePair apart);

    [[nodiscard]] const std::vector<Family>& list() const { return list_; }

   private:
    std::vector<Family> list_;
    std::vector<std::uint32_t> slots_;  ///< open addressing: index in `list_`, or kNone
    unsigned shift_ = 0;
  };

  [[nodiscard]] NodePair parent(NodePair p) const;
  [[nodiscard]] std::size_t child_count(NodePair p) const;
  void test_front(detail::Probe& probe);
  void rise(detail::Probe& probe);

  const Tree* a_;
  const Tree* b_;
  TraversalOptions options_;
  std::vector<std::uint32_t> parents_a_;
  std::vector<std::uint32_t> parents_b_;
  std::vector<NodePair> front_;
  std::vector<NodePair> next_front_;
  std::vector<NodePair> stack_;
  Families families_;
};

namespace detail {

/// Traversal::e_node_front without a last frame: one frame from the roots.
TraversalCounts e_node_front(const PosedTree& a, const PosedTree& b,
                             const TraversalOptions& options, const TraversalVisitor& visitor,
                             TraversalWorkspace& workspace);

}  // namespace detail

}  // namespace soms
