// Tables 3.1 and 3.3: what the models are.
#include "reproduce/counts.h"
#include "reproduce/experiments/experiments.h"

#include <fmt/format.h>

#include <cstdint>

namespace soms::reproduce {

namespace {

Cell integer(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

/// The file that a model was read from, of a generated scene the one that the run writes; empty
/// where there is none.
Cell file_of(const Model& model) {
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
    table.rows.push_back({model.name, model.title, file_of(model), model.stand_in ? "yes" : "no",
                          model.bytes == 0 ? Cell{} : integer(model.bytes),
                          integer(mesh.parts.empty() ? 1 : mesh.parts.size()),
                          integer(mesh.vertices.size()), integer(mesh.triangles.size()), width.x,
                          width.y, width.z, fmt::format("{:016x}", model.hash)});
  }
  return table;
}

/// The thesis names a number of triangles: is there a model of so many, and is it the thesis' own?
Finding number_of_triangles(std::string claim, std::span<const Model> models,
                            std::size_t triangles) {
  Finding finding{.claim = std::move(claim), .source = "abstract"};
  std::string stand_ins;
  for (const Model& model : models) {
    if (model.mesh->triangles.size() == triangles) {
      stand_ins += fmt::format("{}{}", stand_ins.empty() ? "" : ", ", label_of(model));
    }
  }
  finding.measured = stand_ins.empty()
                         ? fmt::format("no model of {} triangles", words(triangles))
                         : fmt::format("{} triangles: {}", words(triangles), stand_ins);
  if (original_of(models, triangles) != nullptr) {
    finding.verdict = Verdict::holds;
    finding.reason = "A model that was given has exactly this count.";
  } else {
    finding.reason = "The thesis' own model was not given; a stand-in of this count shows nothing.";
  }
  return finding;
}

}  // namespace

Result table_3_1(const Context& context) {
  const std::span<const Model> objects = context.models.objects;
  return {.tables = {specification("table_3_1", "The PLY objects.", objects)},
          .findings = {number_of_triangles("An object has 948 triangles", objects, 948)}};
}

Result table_3_3(const Context& context) {
  const std::span<const Model> scenes = context.models.scenes;
  return {.tables = {specification("table_3_3", "The urban scenes, as 3DS.", scenes)},
          .findings = {number_of_triangles("The urban scene has 5,672 triangles", scenes, 5672)}};
}

}  // namespace soms::reproduce
