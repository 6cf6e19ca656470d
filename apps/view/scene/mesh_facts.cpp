#include "apps/view/scene/mesh_facts.h"

#include "apps/view/scene/scene_colors.h"

namespace soms::view {

MeshFacts& MeshFactsStore::of(const std::shared_ptr<const Mesh>& mesh) {
  const auto [entry, added] = facts_.try_emplace(mesh.get());
  if (added) {
    entry->second.mesh = mesh;
    entry->second.key = facts_.size();
  }
  return entry->second;
}

const std::vector<std::uint32_t>& MeshFactsStore::parts(const std::shared_ptr<const Mesh>& mesh) {
  MeshFacts& facts = of(mesh);
  if (facts.parts.empty()) {
    facts.parts = parts_of_triangles(*mesh);
  }
  return facts.parts;
}

const std::shared_ptr<const std::vector<Color>>& MeshFactsStore::building_colors(
    const std::shared_ptr<const Mesh>& mesh) {
  MeshFacts& facts = of(mesh);
  if (facts.building_colors == nullptr) {
    facts.building_colors = std::make_shared<const std::vector<Color>>(colors_by_building(*mesh));
  }
  return facts.building_colors;
}

}  // namespace soms::view
