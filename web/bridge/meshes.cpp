// Meshes and shapes: made from arrays, or read from the bytes of a file.
#include "soms/base/hash.h"
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"
#include "soms/query/instruction_set.h"

#include "web/bridge/answer.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using soms::Mesh;
using soms::web::Answer;
using soms::web::guarded;
using soms::web::HeldShape;

/// A mesh of `vertices` x 3 doubles and `triangles` x 3 indices.
SOMS_EXPORT(soms_mesh)

const Mesh* soms_mesh(const double* coordinates, std::uint32_t vertices,
                      const std::uint32_t* indices, std::uint32_t triangles) {
  return guarded([&]() -> const Mesh* {
    auto mesh = std::make_unique<Mesh>();
    mesh->source = "arrays";
    mesh->vertices.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      mesh->vertices[i] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
    }
    mesh->triangles.resize(triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
      mesh->triangles[i] = {indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]};
    }
    check(*mesh);
    return mesh.release();
  });
}

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
  return guarded([&] {
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * mesh->triangles.size());
    for (const std::array<std::uint32_t, 3>& triangle : mesh->triangles) {
      indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    std::vector<std::uint32_t> parts;
    std::vector<std::uint8_t> names;
    const auto add_name = [&names](const std::string& name) {
      names.insert(names.end(), name.begin(), name.end());
      names.push_back(0);
    };
    for (const soms::Part& part : mesh->parts) {
      parts.insert(parts.end(), {part.first, part.count, part.parent});
      add_name(part.name);
    }
    for (const std::string& note : mesh->notes) {
      add_name(note);
    }
    const std::uint64_t hash = corner_hash(*mesh);
    return soms::web::answer_of(std::vector(mesh->vertices), std::move(indices), std::move(parts),
                                std::move(names),
                                std::vector<double>{mesh->unit, static_cast<double>(mesh->up)},
                                std::vector<std::uint32_t>{static_cast<std::uint32_t>(hash >> 32),
                                                           static_cast<std::uint32_t>(hash)});
  });
}

SOMS_EXPORT(soms_mesh_free) void soms_mesh_free(const Mesh* mesh) {
  delete mesh;
}

/// A shape of a mesh, which is copied; `compact`: the layout for memory.
SOMS_EXPORT(soms_shape) HeldShape* soms_shape(const Mesh* mesh, std::uint32_t compact) {
  return guarded([&] {
    soms::ShapeOptions options;
    options.layout = compact != 0 ? soms::Layout::compact : soms::Layout::wide;
    return new HeldShape(soms::Shape(*mesh, options));
  });
}

SOMS_EXPORT(soms_shape_free) void soms_shape_free(HeldShape* shape) {
  delete shape;
}

/// Columns: bounds f64 x 6 (least and greatest corner); bytes held f64.
SOMS_EXPORT(soms_shape_columns) Answer* soms_shape_columns(const HeldShape* held) {
  return guarded([&] {
    const soms::Box& box = held->shape().bounds();
    return soms::web::answer_of(std::vector<soms::Vec3>{box.lower, box.upper},
                                std::vector<double>{static_cast<double>(held->shape().memory())});
  });
}

/// The instruction set of queries, as text in one column.
SOMS_EXPORT(soms_instruction_set) Answer* soms_instruction_set() {
  return guarded([&] {
    const std::string_view name = soms::instruction_set();
    return soms::web::answer_of(std::vector<std::uint8_t>(name.begin(), name.end()));
  });
}
