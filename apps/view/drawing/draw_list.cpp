#include "apps/view/drawing/draw_list.h"

#include "soms/base/error.h"

#include <cmath>
#include <string>

namespace soms::view {

Box moved(const Pose& pose, const Box& box) {
  if (box.empty()) {
    return box;
  }
  const Vec3 center = pose.apply(box.center());
  const Vec3 half = box.extent() * 0.5;
  const auto& m = pose.m;
  const Vec3 reach{
      std::abs(m[0]) * half.x + std::abs(m[1]) * half.y + std::abs(m[2]) * half.z,
      std::abs(m[4]) * half.x + std::abs(m[5]) * half.y + std::abs(m[6]) * half.z,
      std::abs(m[8]) * half.x + std::abs(m[9]) * half.y + std::abs(m[10]) * half.z,
  };
  return {center - reach, center + reach};
}

Box bounds_beside_meshes(const DrawList& list) {
  Box all;
  for (const TriangleMark& mark : list.marks) {
    all.grow(bounds(mark.corners));
  }
  for (const BoxGroup& group : list.box_groups) {
    for (const BoxItem& item : group.boxes) {
      all.grow(moved(group.pose, item.box));
    }
  }
  for (const Line& line : list.lines) {
    all.grow(line.a);
    all.grow(line.b);
  }
  for (const Point& point : list.points) {
    all.grow(point.at);
  }
  for (const Label& label : list.labels) {
    all.grow(label.a);
    all.grow(label.b);
  }
  return all;
}

Box bounds(const DrawList& list) {
  std::vector<Box> boxes;
  boxes.reserve(list.meshes.size());
  for (const DrawMesh& mesh : list.meshes) {
    boxes.push_back(bounds(*mesh.mesh));
  }
  Box all = bounds_beside_meshes(list);
  for (const Instance& instance : list.instances) {
    all.grow(moved(instance.pose, boxes[instance.mesh]));
  }
  return all;
}

void check(const DrawList& list) {
  for (std::size_t i = 0; i < list.meshes.size(); ++i) {
    const DrawMesh& mesh = list.meshes[i];
    const std::string place = "draw list, mesh " + std::to_string(i);
    if (mesh.mesh == nullptr) {
      throw Error(ErrorKind::usage, place + ": no mesh", "give each entry a mesh");
    }
    if (mesh.colors != nullptr && mesh.colors->size() != mesh.mesh->triangles.size()) {
      throw Error(ErrorKind::usage,
                  place + ": " + std::to_string(mesh.colors->size()) + " colors for " +
                      std::to_string(mesh.mesh->triangles.size()) + " triangles",
                  "give one color a triangle, or none");
    }
  }
  for (std::size_t i = 0; i < list.instances.size(); ++i) {
    if (list.instances[i].mesh >= list.meshes.size()) {
      throw Error(ErrorKind::usage,
                  "draw list, instance " + std::to_string(i) + ": mesh " +
                      std::to_string(list.instances[i].mesh) + " of " +
                      std::to_string(list.meshes.size()),
                  "name a mesh of the list");
    }
  }
}

}  // namespace soms::view
