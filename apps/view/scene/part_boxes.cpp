#include "apps/view/scene/part_boxes.h"

#include "apps/view/drawing/draw_list.h"

#include <cstdint>

namespace soms::view {

namespace {

Box box_of(const MeshView& mesh, const Part& part) {
  Box box;
  for (std::uint32_t i = part.first; i < part.first + part.count; ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      box.grow(mesh.vertices[corner]);
    }
  }
  return box;
}

}  // namespace

Box PartBoxes::operator()(BodyRef body, TriangleId triangle) {
  const MeshView& mesh = scene_.body(body).shape.mesh();
  const auto [entry, added] = parts_.try_emplace(&mesh);
  Parts& parts = entry->second;
  if (added) {
    parts.of = PartsOf(mesh);
    parts.boxes.resize(mesh.parts.size());
  }
  const std::uint32_t part = parts.of(triangle);
  if (part == Part::kNoParent) {
    return scene_.bounds(body);
  }
  Box& box = parts.boxes[part];
  if (box.empty()) {
    box = box_of(mesh, mesh.parts[part]);
  }
  return moved(scene_.body(body).pose, box);
}

}  // namespace soms::view
