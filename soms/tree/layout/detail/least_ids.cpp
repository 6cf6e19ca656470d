#include "soms/tree/layout/detail/least_ids.h"

#include "soms/base/assert.h"

#include <algorithm>
#include <limits>

namespace soms::layout {

namespace {

/// Of the leaf that begins at a block.
TriangleId least_of_leaf(std::span<const TriangleBlock> blocks, std::size_t first) {
  TriangleId least = std::numeric_limits<TriangleId>::max();
  for (std::size_t b = first;; ++b) {
    const TriangleBlock& block = blocks[b];
    // Lanes not in use repeat the last triangle.
    least = std::min(least, *std::min_element(block.id.begin(), block.id.end()));
    if (block.following == 0) {
      return least;
    }
  }
}

}  // namespace

Pages<TriangleId> least_ids(std::span<const WideNode> nodes,
                            std::span<const TriangleBlock> blocks) {
  Pages<TriangleId> ids;
  ids.resize(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const WideNode& node = nodes[i];
    TriangleId least = std::numeric_limits<TriangleId>::max();
    for (std::size_t k = 0; k < node.count; ++k) {
      const std::size_t child = node.child[k] & (WideNode::kMost - 1);
      const bool leaf = (node.leaves >> k & 1U) != 0;
      SOMS_ASSERT(leaf || child > i);
      least = std::min(least, leaf ? least_of_leaf(blocks, child) : ids[child]);
    }
    ids[i] = least;
  }
  return ids;
}

}  // namespace soms::layout
