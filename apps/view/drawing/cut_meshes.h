/// \file
/// Meshes that were cut in tiles before they are drawn, so that the first picture need not wait.
#pragma once

#include "apps/view/drawing/tiles.h"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace soms::view {

/// Tiles of meshes, by key and version. Uses no OpenGL: any one thread at a time.
class CutMeshes {
 public:
  /// Cuts the meshes of a list, and reports the share of triangles done, from any
  /// thread.
  /// \errors ErrorKind::cancelled, and what the progress throws.
  void cut(const DrawList& list, const Limits& limits);

  /// Gives the tiles of a mesh away; nothing for one that was not cut.
  [[nodiscard]] std::optional<TiledMesh> take(const DrawMesh& mesh);

 private:
  std::map<std::pair<std::uint64_t, std::uint64_t>, TiledMesh> cut_;
};

/// The tiles of a mesh with its colors.
[[nodiscard]] TiledMesh tiles_of(const DrawMesh& mesh, const Limits& limits);

}  // namespace soms::view
