// Tables 3.1 and 3.3: what the models are.
#include "thesis/experiments/experiments.h"
#include "thesis/run/counts.h"

#include <fmt/format.h>

#include <cstdint>

namespace soms::reproduce {

namespace {

Cell integer(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

/// The file that a model was read from, of a generated scene the one that the run writes; empty
/// where there is none.
Cell file_name(const Model& model) {
  if (model.file.empty() && model.bytes > 0) {
    return fmt::format("scenes/{}.3ds", model.name);
  }
  return model.file.empty() ? Cell{} : Cell{model.file};
}

Table specification(std::string id, std::string caption, std::span<const Model> models) {
  Table table{.id = std::move(id),
              .caption = caption + note_on_stand_ins(models),
              .columns = {{"model"},
                          {"title"},
                          {"file"},
                          {"stand_in"},
                          {"bytes"},
                          {"objects"},
                          {"vertices"},
                          {"faces"},
                          {"width_x"},
                          {"width_y"},
                          {"width_z"},
                          {"hash"}}};
  for (const Model& model : models) {
    const Mesh& mesh = *model.mesh;
    const Vec3 width = bounds(mesh).upper - bounds(mesh).lower;
    table.rows.push_back({model.name, model.title, file_name(model), model.stand_in ? "yes" : "no",
                          model.bytes == 0 ? Cell{} : integer(model.bytes),
                          integer(mesh.parts.empty() ? 1 : mesh.parts.size()),
                          integer(mesh.vertices.size()), integer(mesh.triangles.size()), width.x,
                          width.y, width.z, fmt::format("{:016x}", model.hash)});
  }
  return table;
}

}  // namespace

Result table_3_1(const Context& context) {
  const std::span<const Model> objects = context.models.objects;
  return {.tables = {specification("table_3_1", "The PLY objects.", objects)}};
}

Result table_3_3(const Context& context) {
  const std::span<const Model> scenes = context.models.scenes;
  return {.tables = {specification("table_3_3", "The urban scenes, as 3DS.", scenes)}};
}

}  // namespace soms::reproduce
