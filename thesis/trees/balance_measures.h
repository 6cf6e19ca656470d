/// \file
/// How balanced a tree is, by several measures.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/tree.h"

namespace soms::reproduce {

/// Measures of a tree's balance.
struct BalanceMeasures {
  /// Leaves with 1 to 4 triangles, the "balance mode" of the thesis; more is more balanced.
  /// \source  thesis, tables 5.4 and 5.10 by their captions.
  double small_leaves = 0;
  /// Greatest level of which every node exists and holds a triangle; greater is more balanced. A
  /// reconstruction: the thesis does not define it.
  double balanced_level = 0;
  /// Mean of |left - right| / n over the nodes that the rule had to divide, n triangles each; one
  /// that stays undivided counts 1, for all its triangles lie on one side. 0 is best. Ours.
  double unevenness = 0;
};

/// Measures a tree. Empty nodes count as no leaves; an empty tree measures 0.
[[nodiscard]] BalanceMeasures balance_of(const Tree& tree, const BuildOptions& options);

}  // namespace soms::reproduce
