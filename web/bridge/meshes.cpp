// Meshes and shapes, made from arrays.
#include "soms/geometry/mesh.h"
#include "soms/query/instruction_set.h"

#include "web/bridge/answer.h"
#include "web/bridge/export.h"
#include "web/bridge/failure.h"
#include "web/bridge/held_shape.h"

#include <memory>
#include <string_view>
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
