/// \file
/// How balanced a tree is, by several measures.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/tree.h"

namespace soms::reproduce {

/// Measures of a tree's balance. All are reconstructions: the thesis defines none.
struct BalanceMeasures {
  /// Greatest level of which every node exists and holds a triangle; greater is more balanced.
  double balanced_level = 0;
  /// Greatest less least depth of a leaf; 0 or 1 in a balanced tree of a textbook.
  double depth_spread = 0;
  /// Mean depth of the leaves less the least that a binary tree of as many leaves can have; 0 is
  /// best.
  double depth_excess = 0;
  /// Mean of |left - right| / n over the nodes that the rule had to divide, n triangles each; one
  /// that stays undivided counts 1, for all its triangles lie on one side. 0 is best.
  double unevenness = 0;
};

/// Measures a tree. Empty nodes count as no leaves; an empty tree measures 0.
[[nodiscard]] BalanceMeasures balance_of(const Tree& tree, const BuildOptions& options);

}  // namespace soms::reproduce
