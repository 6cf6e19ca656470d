/// \file
/// What traversals do step by step, on two bodies small enough to be drawn.
#pragma once

#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversal_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::reproduce {

/// Two bodies of four triangles each, that overlap in the middle, with their trees by SOMS.
struct ToyPair {
  ToyPair();
  ToyPair(const ToyPair&) = delete;
  ToyPair& operator=(const ToyPair&) = delete;

  Mesh mesh_a;
  Mesh mesh_b;
  Tree tree_a;
  Tree tree_b;
  PosedBoxes boxes_a;
  PosedBoxes boxes_b;
};

/// What happened to a pair of nodes, by number of the step; 0 where it did not.
struct Story {
  NodePair pair;
  std::size_t tested = 0;
  std::size_t entered = 0;
  std::size_t reported = 0;
  bool overlap = false;
  std::size_t parent = 0;  ///< index of the pair it came from; its own for the roots
};

/// A step of a traversal.
struct Event {
  std::string what;  ///< "test", "enter" or "report"
  NodePair pair;
  std::string outcome;
};

/// A traversal as it went.
struct Course {
  std::string name;
  std::vector<Story> stories = {};
  std::vector<Event> events = {};
  TraversalCounts counts = {};
};

/// Writes down what a traversal does. \pre It descends both nodes: the parent of a pair is the pair
/// of the parents.
[[nodiscard]] Course record(const ToyPair& toy, const std::string& name,
                            const TraversalOptions& options);

/// "1|2": TreeIDs of the still node and the moving node.
[[nodiscard]] std::string pair_words(const ToyPair& toy, NodePair p);

}  // namespace soms::reproduce
