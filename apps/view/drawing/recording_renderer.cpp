#include "apps/view/drawing/recording_renderer.h"

#include "soms/base/error.h"

#include "apps/view/drawing/labels.h"

namespace soms::view {

void RecordingRenderer::draw(const DrawList& list, const Camera& camera, Size size,
                             const DrawOptions& options) {
  check(list);
  if (size.width < 1 || size.height < 1) {
    throw Error(ErrorKind::usage, "picture: a size below 1", "give a width and a height above 0");
  }
  ++drawn_;
  list_ = list;
  camera_ = camera;
  size_ = size;
  options_ = options;
  statistics_ = {};
  statistics_.instances = list.instances.size();
  statistics_.marks = list.marks.size();
  statistics_.lines = list.lines.size();
  statistics_.points = list.points.size();
  statistics_.labels = place_labels(list.labels, camera, size).size();
  for (const Instance& instance : list.instances) {
    statistics_.triangles += list.meshes[instance.mesh].mesh->triangles.size();
  }
  std::set<std::pair<std::uint64_t, std::uint64_t>> named;
  for (const DrawMesh& mesh : list.meshes) {
    named.insert({mesh.key, mesh.version});
  }
  for (const BoxGroup& group : list.box_groups) {
    statistics_.boxes += group.boxes.size();
  }
  for (const auto& one : named) {
    statistics_.uploads += uploaded_.count(one) == 0 ? 1U : 0U;
  }
  uploaded_ = std::move(named);
}

Picture RecordingRenderer::read_pixels() {
  if (drawn_ == 0) {
    throw Error(ErrorKind::usage, "picture: nothing was drawn yet", "draw a frame first");
  }
  return filled(size_, list_.background.lower);
}

}  // namespace soms::view
