#include "thesis/trips/object_meshes.h"

#include <map>
#include <utility>

namespace soms::reproduce {

std::vector<Mesh> object_meshes(const Mesh& mesh) {
  // Part::kNoParent is the greatest number, so what belongs to no part comes last.
  std::map<std::uint32_t, Mesh> by_part;
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    Mesh& object = by_part[part_of(mesh, id)];
    const Triangle corners = mesh.triangle(id);
    const auto first = static_cast<std::uint32_t>(object.vertices.size());
    object.vertices.insert(object.vertices.end(), {corners.a, corners.b, corners.c});
    object.triangles.push_back({first, first + 1, first + 2});
  }
  std::vector<Mesh> objects;
  objects.reserve(by_part.size());
  for (auto& [part, object] : by_part) {
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace soms::reproduce
