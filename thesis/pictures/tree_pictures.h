/// \file
/// Pictures of trees: the boxes of one level above the mesh.
#pragma once

#include "soms/tree/tree.h"

#include "thesis/pictures/drawing.h"
#include "thesis/run/result.h"

#include <string>

namespace soms::reproduce {

/// What a level of a tree holds. Level 1 is the root alone.
struct LevelCount {
  std::int64_t nodes = 0;   ///< nodes of the level
  std::int64_t ended = 0;   ///< leaves of levels above
  std::int64_t most = 0;    ///< most triangles of a node of the level or a leaf above
  std::int64_t fewest = 0;  ///< fewest of these
};

[[nodiscard]] LevelCount count_level(const Tree& tree, int level);

/// The mesh, the boxes of a level, and dashed those of leaves above it. The note says how many.
/// The mesh must outlive the panel.
[[nodiscard]] Panel level_panel(const Mesh& mesh, const Tree& tree, int level, std::string title);

/// Legend of such panels.
[[nodiscard]] std::vector<Key> level_keys();

}  // namespace soms::reproduce
