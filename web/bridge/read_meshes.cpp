// Meshes read from the bytes of a file, and all that a mesh holds.
#include "soms/base/hash.h"
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"

#include "web/bridge/answer.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

using soms::Mesh;
using soms::web::Answer;
using soms::web::guarded;
using soms::web::HeldShape;

namespace {

Answer* columns_of(const soms::MeshView& mesh) {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * mesh.triangles.size());
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  std::vector<std::uint32_t> parts;
  std::vector<std::uint8_t> names;
  const auto add_name = [&names](const std::string& name) {
    names.insert(names.end(), name.begin(), name.end());
    names.push_back(0);
  };
  for (const soms::Part& part : mesh.parts) {
    parts.insert(parts.end(), {part.first, part.count, part.parent});
    add_name(part.name);
  }
  for (const std::string& note : mesh.notes) {
    add_name(note);
  }
  const std::uint64_t hash = corner_hash(mesh);
  return soms::web::answer_of(std::vector<soms::Vec3>(mesh.vertices.begin(), mesh.vertices.end()),
                              std::move(indices), std::move(parts), std::move(names),
                              std::vector<double>{mesh.unit, static_cast<double>(mesh.up)},
                              std::vector<std::uint32_t>{static_cast<std::uint32_t>(hash >> 32),
                                                         static_cast<std::uint32_t>(hash)});
}

}  // namespace

/// The mesh in a file's bytes; `name` is its name in UTF-8, ended by 0.
SOMS_EXPORT(soms_read_mesh)

const Mesh* soms_read_mesh(const std::byte* bytes, std::uint32_t size, const char* name,
                           std::uint32_t strict) {
  return guarded([&]() -> const Mesh* {
    soms::ReadOptions options;
    options.strict = strict != 0;
    return new Mesh(soms::read_mesh(std::span(bytes, size), std::string(name), options));
  });
}

/// Columns: vertices f64 x 3, triangles u32 x 3; parts' first triangles, counts and parents u32;
/// their names and then the notes in UTF-8, each ended by 0; unit f64 and up axis f64; the corner
/// hash, its upper and lower half u32.
SOMS_EXPORT(soms_mesh_columns) Answer* soms_mesh_columns(const Mesh* mesh) {
  return guarded([&] { return columns_of(*mesh); });
}

/// Columns as of `soms_mesh_columns`, of a shape's mesh.
SOMS_EXPORT(soms_shape_mesh_columns) Answer* soms_shape_mesh_columns(const HeldShape* held) {
  return guarded([&] { return columns_of(held->shape().mesh()); });
}
