#include "apps/view/drawing/cut_meshes.h"

namespace soms::view {

TiledMesh tiles_of(const DrawMesh& mesh, const Limits& limits) {
  return cut_in_tiles(*mesh.mesh,
                      mesh.colors == nullptr ? std::span<const Color>{} : std::span(*mesh.colors),
                      {}, limits);
}

void CutMeshes::cut(const DrawList& list, const Limits& limits) {
  double all = 1;
  for (const DrawMesh& mesh : list.meshes) {
    all += static_cast<double>(mesh.mesh->triangles.size());
  }
  double done = 0;
  for (const DrawMesh& mesh : list.meshes) {
    const auto count = static_cast<double>(mesh.mesh->triangles.size());
    Limits part = limits;
    if (limits.progress) {
      part.progress = [&](double share) { limits.progress((done + share * count) / all); };
    }
    cut_.insert_or_assign({mesh.key, mesh.version}, tiles_of(mesh, part));
    done += count;
  }
}

std::optional<TiledMesh> CutMeshes::take(const DrawMesh& mesh) {
  auto known = cut_.extract({mesh.key, mesh.version});
  return known.empty() ? std::nullopt : std::optional(std::move(known.mapped()));
}

}  // namespace soms::view
