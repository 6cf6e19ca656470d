#include "soms/geometry/reference/bodies_of.h"

#include "soms/geometry/closedness.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace soms::reference {

namespace {

using Parts = std::vector<std::uint32_t>;

/// A bit for each of some parts.
using Choice = std::uint32_t;

std::map<std::uint32_t, Mesh> meshes_by_part(const MeshView& mesh) {
  std::map<std::uint32_t, Mesh> meshes;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Mesh& part = meshes[part_of(mesh, static_cast<TriangleId>(i))];
    part.vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
    part.triangles.push_back(mesh.triangles[i]);
  }
  return meshes;
}

bool are_closed(const std::map<std::uint32_t, Mesh>& meshes, const Parts& parts, Choice choice) {
  Mesh together;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if ((choice >> k & 1U) != 0) {
      const Mesh& part = meshes.at(parts[k]);
      together.vertices = part.vertices;
      together.triangles.insert(together.triangles.end(), part.triangles.begin(),
                                part.triangles.end());
    }
  }
  return closedness(together, {.places = 0}).whole.closed;
}

/// The least closed sets of some parts that meet no other one.
std::vector<Choice> without_choice(const std::map<std::uint32_t, Mesh>& meshes,
                                   const Parts& parts) {
  std::vector<Choice> least;
  for (Choice choice = 1; choice < Choice{1} << parts.size(); ++choice) {
    if (are_closed(meshes, parts, choice)) {
      least.push_back(choice);
    }
  }
  const std::vector<Choice> closed = least;
  std::erase_if(least, [&](Choice choice) {
    return std::any_of(closed.begin(), closed.end(), [&](Choice smaller) {
      return smaller != choice && (smaller & choice) == smaller;
    });
  });
  const std::vector<Choice> all = least;
  std::erase_if(least, [&](Choice choice) {
    return std::any_of(all.begin(), all.end(),
                       [&](Choice other) { return other != choice && (other & choice) != 0; });
  });
  return least;
}

bool holds(const MeshView& mesh, std::uint32_t object, std::uint32_t part) {
  while (part != object && part != Part::kNoParent) {
    part = mesh.parts[part].parent;
  }
  return part == object;
}

std::size_t depth_of(const MeshView& mesh, std::uint32_t part) {
  std::size_t depth = 0;
  for (; part != Part::kNoParent; part = mesh.parts[part].parent) {
    ++depth;
  }
  return depth;
}

}  // namespace

std::vector<PartGroup> closed_bodies_by_brute_force(const MeshView& mesh) {
  const std::map<std::uint32_t, Mesh> meshes = meshes_by_part(mesh);
  std::vector<PartGroup> groups;
  Parts open;
  for (const auto& [part, triangles] : meshes) {
    if (closedness(triangles, {.places = 0}).whole.closed) {
      groups.push_back({.parts = {part}, .closed = true});
    } else {
      open.push_back(part);
    }
  }
  Parts objects;
  for (std::uint32_t object = 0; object < mesh.parts.size(); ++object) {
    objects.push_back(object);
  }
  std::stable_sort(objects.begin(), objects.end(), [&](std::uint32_t a, std::uint32_t b) {
    return depth_of(mesh, a) > depth_of(mesh, b);
  });
  objects.push_back(Part::kNoParent);  // the whole mesh
  for (const std::uint32_t object : objects) {
    Parts held;
    for (const std::uint32_t part : open) {
      if (object == Part::kNoParent || (part != Part::kNoParent && holds(mesh, object, part))) {
        held.push_back(part);
      }
    }
    for (const Choice choice : without_choice(meshes, held)) {
      PartGroup group{.closed = true};
      for (std::size_t k = 0; k < held.size(); ++k) {
        if ((choice >> k & 1U) != 0) {
          group.parts.push_back(held[k]);
          std::erase(open, held[k]);
        }
      }
      groups.push_back(std::move(group));
    }
  }
  std::sort(groups.begin(), groups.end(), [](const PartGroup& a, const PartGroup& b) {
    return a.parts.front() < b.parts.front();
  });
  return groups;
}

}  // namespace soms::reference
