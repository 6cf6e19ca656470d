// Figures 3.7, 3.9 and 4.41 to 4.43: the objects, the scenes, and the way of a city through a file.
#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "thesis/experiments/experiments.h"
#include "thesis/pictures/drawing.h"
#include "thesis/trips/frames.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace soms::reproduce {

namespace {

std::int64_t number(std::size_t value) {
  return static_cast<std::int64_t>(value);
}

Figure models_figure(const std::string& id, const std::string& caption, Drawing drawing,
                     std::span<const Model> models) {
  drawing.same_scale = false;
  std::string alt;
  for (const Model& model : models) {
    const Mesh& mesh = *model.mesh;
    drawing.panels.push_back(
        {.title = model.title.empty() ? model.name : model.title,
         .note = fmt::format("{} triangles, {} vertices{}", to_text(number(mesh.triangles.size())),
                             to_text(number(mesh.vertices.size())),
                             model.stand_in ? "; a stand-in" : ""),
         .meshes = {{.mesh = &mesh}}});
    alt += fmt::format("{}: {}. ", drawing.panels.back().title, drawing.panels.back().note);
  }
  return {.id = id, .caption = caption, .svg = draw(drawing), .alt = alt};
}

/// The object as it drives through a scene.
Model test_object(const Model& object) {
  Model enlarged = object;
  enlarged.mesh = std::make_shared<const Mesh>(transformed(*object.mesh, kDriveScale, UpAxis::y));
  const Vec3 width = bounds(*enlarged.mesh).extent();
  enlarged.title = fmt::format("Test object: {}, {} times as large, {:.3g} by {:.3g} by {:.3g}",
                               object.name, kDriveScale, width.x, width.y, width.z);
  return enlarged;
}

std::size_t parts_of(const Mesh& mesh) {
  return mesh.parts.empty() ? 1 : mesh.parts.size();
}

/// A row that compares a scene with what its .3ds gives when it is read. An empty answer, or why it
/// could not be compared.
std::string compare_with_file(const Model& scene, const Limits& limits, Table& table) {
  const Mesh& mesh = *scene.mesh;
  std::string file;
  std::optional<Mesh> back;
  try {
    file = scene_file(scene);
    Limits one;
    one.stop = limits.stop;
    back = read_mesh(std::as_bytes(std::span(file)), scene.name + ".3ds", {}, one);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      throw;
    }
    return fmt::format("{} could not be written and read back: {}", scene.name, error.what());
  }
  const std::uint64_t hash = corner_hash(*back);
  const bool equal =
      hash == scene.hash && back->vertices == mesh.vertices && back->triangles == mesh.triangles;
  table.rows.push_back({scene.name, number(file.size()), number(parts_of(mesh)),
                        number(parts_of(*back)), number(mesh.vertices.size()),
                        number(back->vertices.size()), number(mesh.triangles.size()),
                        number(back->triangles.size()), fmt::format("{:016x}", scene.hash),
                        fmt::format("{:016x}", hash), std::string(equal ? "yes" : "no")});
  return {};
}

}  // namespace

Result figure_3_7(const Context& context) {
  return {.figures = {models_figure(
              "figure_3_7", "The objects as they are stored, y upwards, each at its own scale.",
              {.title = "The objects", .view = axonometric(UpAxis::y)}, context.models.objects)}};
}

Result figure_3_9(const Context& context) {
  const std::vector<Model>& scenes = context.models.scenes;
  const std::array beside{test_object(context.models.objects.front()), scenes.front()};
  return {
      .figures = {
          models_figure(
              "figure_3_9",
              fmt::format("Left the test object, turned z upwards and {} times as large as its "
                          "file, as it moves through the scenes; right a scene, at a scale of "
                          "its own.",
                          kDriveScale),
              {.title = "The test object and its surroundings", .view = axonometric(UpAxis::z)},
              beside),
          models_figure("figure_3_9_scenes", "The urban scenes from above, each at its own scale.",
                        {.title = "The urban scenes", .view = axonometric(UpAxis::z), .columns = 1},
                        scenes)}};
}

Result figure_4_41(const Context& context) {
  return {.figures = {models_figure(
              "figure_4_41", "The whole city, from above one of its corners.",
              {.title = "The whole city", .view = axonometric(UpAxis::z), .columns = 1},
              std::span(context.models.scenes).first(1))}};
}

Result figure_4_42(const Context& context) {
  return {.figures = {models_figure(
              "figure_4_42", "The city as it was read from its .3ds, from the opposite corner.",
              {.title = "The city as it is loaded",
               .view = {{0.8, -0.6, -0.45}, {0, 0, 1}},
               .columns = 1},
              std::span(context.models.scenes).first(1))}};
}

Result figure_4_43(const Context& context) {
  Result result;
  Table table{.id = "figure_4_43_reading",
              .caption =
                  "Each scene written as .3ds and read back: bytes of the file, what was "
                  "written and what was read, hashes of all corners, and whether vertices "
                  "and triangles are equal to the last bit.",
              .columns = {{"model"},
                          {"bytes"},
                          {"objects_written"},
                          {"objects_read"},
                          {"vertices_written"},
                          {"vertices_read"},
                          {"faces_written"},
                          {"faces_read"},
                          {"hash_written"},
                          {"hash_read"},
                          {"equal"}}};
  for (const Model& scene : context.models.scenes) {
    check_stop(context.limits);
    std::string trouble = compare_with_file(scene, context.limits, table);
    if (!trouble.empty()) {
      result.remarks.push_back(std::move(trouble));
    }
  }
  result.tables = {std::move(table)};
  return result;
}

}  // namespace soms::reproduce
