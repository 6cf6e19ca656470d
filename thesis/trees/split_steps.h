/// \file
/// How a tree of SOMS came about, node by node.
#pragma once

#include "soms/tree/tree.h"

#include "thesis/run/result.h"
#include "thesis/trees/toy_sets.h"

#include <span>
#include <string>
#include <vector>

namespace soms::reproduce {

/// What happened to a node when the tree was built.
struct SplitStep {
  const Node* node = nullptr;
  bool divided = false;
  ToySplit split = {};  ///< of the node's triangles; empty for a node that no rule looked at
  std::string outcome;  ///< "divided", or why it is a leaf
};

/// The nodes of a tree with the thesis' options for SOMS and this level, in the order in which they
/// are made (depth first, left first). The tree must outlive the steps.
/// \errors std::logic_error where the rule and the tree do not agree: a fault of the library.
[[nodiscard]] std::vector<SplitStep> split_steps(const Mesh& mesh, const Tree& tree, int level);

/// A row for each step.
[[nodiscard]] Table split_table(std::string id, std::string caption,
                                std::span<const SplitStep> steps);

}  // namespace soms::reproduce
