#include "soms/io/detail/tiles/tile_meshes.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace soms::detail {

namespace {

/// Takes one mesh after the other; memory for all was reserved.
class TileJoiner {
 public:
  TileJoiner(Source& source, const std::vector<NamedMesh>& meshes);

  void add(NamedMesh&& tile);

  [[nodiscard]] Mesh finish() { return std::move(mesh_); }

 private:
  void add_parts(NamedMesh& tile);

  Source& source_;
  Mesh mesh_;
};

TileJoiner::TileJoiner(Source& source, const std::vector<NamedMesh>& meshes) : source_(source) {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t parts = 0;
  for (const NamedMesh& tile : meshes) {
    vertices += tile.mesh.vertices.size();
    triangles += tile.mesh.triangles.size();
    parts += tile.mesh.parts.size() + 1;
  }
  if (vertices > kMaxPrimitives || triangles > kMaxPrimitives) {
    source.fail(ErrorKind::out_of_range, "more than 2^31 - 1 vertices or triangles",
                "read fewer tiles");
  }
  const std::uint64_t bytes =
      vertices * sizeof(Vec3) + triangles * sizeof(mesh_.triangles[0]) + parts * sizeof(Part);
  if (!source.budget.take(bytes)) {
    source.fail_memory(bytes);
  }
  mesh_.vertices.reserve(static_cast<std::size_t>(vertices));
  mesh_.triangles.reserve(static_cast<std::size_t>(triangles));
  mesh_.parts.reserve(static_cast<std::size_t>(parts));
}

void TileJoiner::add_parts(NamedMesh& tile) {
  const auto first = static_cast<std::uint32_t>(mesh_.triangles.size());
  const auto around = static_cast<std::uint32_t>(mesh_.parts.size());
  mesh_.parts.push_back({std::move(tile.name), Part::kNoParent, first,
                         static_cast<std::uint32_t>(tile.mesh.triangles.size())});
  for (Part& part : tile.mesh.parts) {
    part.first += first;
    part.parent = part.parent == Part::kNoParent ? around : part.parent + around + 1;
    if (part.continues != Part::kNoParent) {
      part.continues += around + 1;
    }
    mesh_.parts.push_back(std::move(part));
  }
}

void TileJoiner::add(NamedMesh&& tile) {
  check(source_.limits);
  for (const std::string& note : tile.mesh.notes) {
    std::string text = tile.name + ": " + note;
    if (!source_.budget.take(3 * sizeof(std::string) + text.capacity())) {
      source_.fail_memory(text.capacity());
    }
    mesh_.notes.push_back(std::move(text));
  }
  if (tile.mesh.triangles.empty()) {
    return;
  }
  add_parts(tile);
  const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
  mesh_.vertices.insert(mesh_.vertices.end(), tile.mesh.vertices.begin(), tile.mesh.vertices.end());
  for (const auto& [a, b, c] : tile.mesh.triangles) {
    mesh_.triangles.push_back({first + a, first + b, first + c});
  }
}

/// Names of the parts around a part, from the outside in, and its id.
std::string path_of(const MeshView& mesh, const Part& part) {
  std::string path = part.id;
  for (std::uint32_t at = part.parent; at != Part::kNoParent; at = mesh.parts[at].parent) {
    if (!mesh.parts[at].name.empty()) {
      path = mesh.parts[at].name + "/" + path;
    }
  }
  return path;
}

}  // namespace

Mesh join_tiles(Source& source, std::vector<NamedMesh> meshes) {
  TileJoiner joiner(source, meshes);
  for (NamedMesh& tile : meshes) {
    joiner.add(std::move(tile));
    tile.mesh = {};
  }
  return joiner.finish();
}

void make_ids_unique(Source& source, Mesh& mesh) {
  const auto take = [&](std::uint64_t bytes) {
    if (!source.budget.take(bytes)) {
      source.fail_memory(bytes);
    }
  };
  constexpr std::uint64_t kBytesPerId = 128;
  take(2 * kBytesPerId * mesh.parts.size());
  std::unordered_map<std::string_view, std::size_t> counts;
  for (const Part& part : mesh.parts) {
    counts[part.id] += part.id.empty() ? 0U : 1U;
  }
  std::vector<std::pair<Part*, std::string>> renamed;
  for (Part& part : mesh.parts) {
    if (!part.id.empty() && counts[part.id] > 1) {
      renamed.emplace_back(&part, path_of(mesh, part));
      take(renamed.back().second.size());
    }
  }
  std::unordered_set<std::string> used;
  for (const auto& [id, count] : counts) {
    if (count == 1) {
      used.emplace(id);
      take(id.size());
    }
  }
  for (auto& [part, path] : renamed) {
    std::string id = path;
    for (std::size_t number = 2; !used.insert(id).second; ++number) {
      id = path + "#" + std::to_string(number);
    }
    part->id = std::move(id);
  }
}

}  // namespace soms::detail
