/// \file
/// What a shown mesh is drawn with, found once for each mesh: its key, colors, and parts.
#pragma once

#include "apps/view/drawing/draw_list.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace soms::view {

/// Facts of one mesh.
struct MeshFacts {
  std::shared_ptr<const Mesh> mesh;
  std::uint64_t key = 0;  ///< for `DrawMesh`; never 0, never used for another mesh of the scene
  std::shared_ptr<const std::vector<Color>> building_colors;  ///< once requested
  std::vector<std::uint32_t> parts;                           ///< once requested
};

/// Facts by mesh. Keeps the meshes alive, so that no address is used twice.
class MeshFactsStore {
 public:
  /// Facts without colors and parts. References last.
  [[nodiscard]] MeshFacts& of(const std::shared_ptr<const Mesh>& mesh);

  /// Innermost part of each triangle.
  [[nodiscard]] const std::vector<std::uint32_t>& parts(const std::shared_ptr<const Mesh>& mesh);

  /// Colors by building.
  [[nodiscard]] const std::shared_ptr<const std::vector<Color>>& building_colors(
      const std::shared_ptr<const Mesh>& mesh);

 private:
  std::map<const Mesh*, MeshFacts> facts_;
};

}  // namespace soms::view
