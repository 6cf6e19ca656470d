/// \file
/// Diagrams of trees: a circle with its TreeID for each node, below its parent.
#pragma once

#include "soms/tree/tree.h"

#include <functional>
#include <string>
#include <vector>

namespace soms::reproduce {

/// A tree and what is written at it.
struct TreeDiagram {
  std::string title;
  std::string subtitle = {};
  const Tree* tree = nullptr;  ///< with at least one node; all have a TreeID
  /// Words below a node, line by line; none if not set.
  std::function<std::vector<std::string>(const Node& node)> words = {};
  /// Words at the left of a depth, line by line; none if not set.
  std::function<std::vector<std::string>(std::uint32_t depth)> row_words = {};
};

/// The diagram as SVG: a row for each depth; left children with blue circles, right ones with
/// orange.
[[nodiscard]] std::string draw_tree(const TreeDiagram& diagram);

}  // namespace soms::reproduce
