#include "soms/io/detail/gltf/gltf_meshes.h"

#include <optional>

namespace soms::detail {

namespace {

constexpr std::uint64_t kLastOfPointsAndLines = 3;

/// Compressed primitives may state positions or indices that stand nowhere, which would read as
/// zeros. Where nothing else says what they are, any extension may.
void refuse_compressed(const JsonValue& primitive, const GltfAccessor& accessor) {
  if (accessor.json.find("bufferView")) {
    return;
  }
  for (const JsonValue& holder : {primitive, accessor.json}) {
    const std::optional<JsonValue> extensions = holder.find("extensions");
    if (!extensions) {
      continue;
    }
    for (const char* const name : {"KHR_draco_mesh_compression", "KHR_gaussian_splatting"}) {
      if (extensions->find(name)) {
        refuse_extension(holder, name);
      }
    }
    const std::optional<std::string_view> other = extensions->first_name();
    if (other && accessor.sparse_count == 0) {
      refuse_extension(holder, *other);
    }
  }
}

std::uint64_t triangles_of(const JsonValue& primitive, GltfMode mode, std::uint64_t corners) {
  if (corners < 3 || (mode == GltfMode::triangles && corners % 3 != 0)) {
    primitive.fail(std::to_string(corners) + " corners are no whole number of triangles");
  }
  return mode == GltfMode::triangles ? corners / 3 : corners - 2;
}

}  // namespace

void GltfMeshes::add_primitive(GltfMesh& mesh, const JsonValue& json) {
  const std::optional<JsonValue> stated = json.find("mode");
  const std::uint64_t mode = stated ? stated->whole() : std::uint64_t{4};
  if (mode > static_cast<std::uint64_t>(GltfMode::fan)) {
    stated->fail(std::to_string(mode) + " is not a mode; modes are 0 to 6");
  }
  const auto place = [&] { return "in " + json.path(); };
  const std::optional<JsonValue> reference = json.at("attributes").find("POSITION");
  if (mode <= kLastOfPointsAndLines || !reference) {
    (mode <= kLastOfPointsAndLines ? points_and_lines_ : without_positions_).add(place);
    return;
  }
  constexpr std::uint64_t kBytesPerPrimitive = 3 * sizeof(GltfPrimitive) + 64;
  if (!source_.budget.take(kBytesPerPrimitive)) {
    source_.fail_memory(kBytesPerPrimitive);
  }
  const GltfAccessor& positions = accessors_.positions(*reference);
  refuse_compressed(json, positions);
  const auto [number, is_new] = numbers_.try_emplace(&positions, mesh.positions.size());
  if (is_new) {
    mesh.positions.push_back(&positions);
    mesh.vertices += positions.count;
  }
  GltfPrimitive primitive{.json = json,
                          .positions = number->second,
                          .mode = static_cast<GltfMode>(static_cast<std::uint8_t>(mode))};
  if (const auto indices = json.find("indices")) {
    primitive.indices = &accessors_.indices(*indices);
    refuse_compressed(json, *primitive.indices);
  }
  primitive.triangles =
      triangles_of(json, primitive.mode,
                   primitive.indices != nullptr ? primitive.indices->count : positions.count);
  mesh.triangles += primitive.triangles;
  if (json.find("targets")) {
    morphed_.add(place);
  }
  mesh.primitives.push_back(primitive);
}

const GltfMesh& GltfMeshes::mesh(const JsonValue& reference) {
  const JsonValue json = reference.referred("meshes");
  const auto [known, is_new] = loaded_.try_emplace(reference.whole());
  if (is_new) {
    numbers_.clear();
    const JsonValue primitives = json.at("primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      if (i % kRowsPerTick == 0) {
        check(source_.limits);
      }
      add_primitive(known->second, primitives.at(i));
    }
  }
  return known->second;
}

void GltfMeshes::add_notes(std::vector<std::string>& notes) const {
  add_note(notes, points_and_lines_, "primitives of points or lines, which are not triangles");
  add_note(notes, without_positions_, "primitives without positions, not read");
  add_note(notes, morphed_, "primitives with morph targets, which are not applied");
}

}  // namespace soms::detail
