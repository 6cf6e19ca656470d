/// \file
/// What all traversals of two trees share: the posed tree, the visitor, the counters.
#pragma once

#include "soms/base/box.h"
#include "soms/tree/tree.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace soms {

/// A tree with the boxes of its nodes at a place. A view: tree and boxes belong to the caller.
/// Moving a tree means giving it other boxes (`PosedBoxes`).
struct PosedTree {
  const Tree* tree = nullptr;
  std::span<const Box> boxes = {};  ///< one world box a node of `tree`, in the order of its nodes
};

/// Indices of a node of the first tree and a node of the second.
struct NodePair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  [[nodiscard]] bool operator==(const NodePair&) const = default;
};

/// Work of a traversal. The same on every machine.
struct TraversalCounts {
  std::uint64_t box_tests = 0;       ///< pairs of boxes tested
  std::uint64_t entered = 0;         ///< pairs taken from the stack, or recursed into
  std::uint64_t leaf_pairs = 0;      ///< overlapping pairs of leaves that were reported
  std::uint64_t triangle_pairs = 0;  ///< sum over those of the product of their triangle counts
  std::uint64_t first_tests = 0;  ///< box tests up to the first report; 0 where nothing is reported
  std::uint64_t max_stack = 0;    ///< most pairs waiting at once; by recursion: greatest nesting

  [[nodiscard]] bool operator==(const TraversalCounts&) const = default;

  /// Sums counts over frames; `max_stack` is the greater of both.
  TraversalCounts& operator+=(const TraversalCounts& other);
};

/// Box tests between two calls of TraversalVisitor::keep_going.
inline constexpr std::uint64_t kBoxTestsBetweenAsks = 1024;

/// What a traversal calls; each may be empty.
struct TraversalVisitor {
  /// A pair of leaves whose boxes overlap, each once, in the order found. False stops.
  std::function<bool(NodePair)> leaf_pair = {};
  /// Called once in kBoxTestsBetweenAsks box tests, for deadlines and cancellation. False stops.
  std::function<bool()> keep_going = {};
  /// Each pair of boxes tested, and whether they overlap: for pictures and tests.
  std::function<void(NodePair, bool)> tested = {};
  /// Each pair entered: for pictures and tests.
  std::function<void(NodePair)> entered = {};
};

/// Memory that a traversal may reuse from call to call.
struct TraversalWorkspace {
  std::vector<NodePair> stack;
};

}  // namespace soms
