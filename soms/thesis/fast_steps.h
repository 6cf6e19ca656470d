/// \file
/// The default traversal taken apart, for teaching: the tests that `soms::overlap` makes, in order.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::thesis {

/// What is tested in a step.
enum class FastTest : std::uint8_t {
  whole,    ///< the boxes of both bodies: always the first step
  one_box,  ///< a small body goes down the tree of the large one as one box
  nodes,    ///< boxes of a node of a against boxes of a node of b, up to four each
  larger,   ///< boxes of the larger node, each against the other node as a whole
  /// Triangles of leaves that are large beside a node: where none is near it, the pair ends. Only
  /// their number is known.
  large_leaves,
  leaves,  ///< up to eight triangles of a leaf against as many of another
};

/// Tests that are made together. Nodes and blocks are those of the bodies' layouts
/// (`WideTree::nodes`, `WideTree::blocks`).
struct FastStep {
  FastTest test = FastTest::whole;
  std::uint32_t a = 0;       ///< node of a, the root first; of `leaves` a block of triangles
  std::uint32_t b = 0;       ///< likewise of b
  std::uint8_t boxes_a = 0;  ///< boxes of the node that are tested, one a bit; 0: it as a whole
  std::uint8_t boxes_b = 0;
  /// Pairs that may meet, and are looked into later: bit 4 i + k for box i of a and box k of b; of
  /// a node as a whole the box is 0. None of `leaves`.
  std::uint16_t meet = 0;
  std::uint64_t node_tests = 0;  ///< what the step adds to `Cost::node_tests`
  /// Pairs of triangles that were compared after this step. Pairs wait until there are enough for
  /// the processor's lanes, so those of some steps are compared together.
  std::uint64_t triangle_tests = 0;
  std::uint64_t found = 0;  ///< touching pairs known after this step

  [[nodiscard]] bool operator==(const FastStep&) const = default;
};

struct FastSteps {
  std::vector<FastStep> steps;
  Cost cost;         ///< of the traversal; where it is whole that of `soms::overlap` on one thread
  bool cut = false;  ///< there are more steps
};

/// Traverses two bodies as `soms::overlap` does on one thread, all pairs requested, and notes what
/// it tests. The traversal is the product's own: it is watched from outside, and costs queries
/// nothing.
/// \shape  `steps`: at most `most`, and those of one round more.
/// \errors As `soms::overlap`; ErrorKind::usage for a body that is kept compact.
[[nodiscard]] FastSteps fast_steps(const Body& a, const Body& b, std::size_t most = 100'000,
                                   const Limits& limits = {});

}  // namespace soms::thesis
