// Figures 4.39 and 4.40: the city made of four parts, and its first part.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/drawing.h"
#include "thesis/run/counts.h"
#include "thesis/run/traversal_tables.h"
#include "thesis/trees/toy_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace soms::reproduce {

namespace {

/// Which of the four parts holds a triangle; the last: none alone.
constexpr std::size_t kParts = 4;
constexpr std::size_t kAcrossParts = kParts;

/// A scene cut in four by the middles of x and y.
struct Quarters {
  Vec3 middle;
  Vec3 extent;
  std::vector<std::size_t> part = {};  ///< of each triangle
};

Quarters quarters_of(const Mesh& mesh) {
  const Box all = bounds(mesh);
  Quarters quarters{.middle = all.center(), .extent = all.extent()};
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    const Box box = bounds(mesh.triangle(id));
    const bool across = (box.lower.x < quarters.middle.x && box.upper.x > quarters.middle.x) ||
                        (box.lower.y < quarters.middle.y && box.upper.y > quarters.middle.y);
    const std::size_t right = box.upper.x > quarters.middle.x ? 1 : 0;
    const std::size_t upper = box.upper.y > quarters.middle.y ? 2 : 0;
    quarters.part.push_back(across ? kAcrossParts : right + upper);
  }
  return quarters;
}

/// The file's object that a triangle belongs to, without one the scene itself.
std::string object_of(const Mesh& mesh, TriangleId id) {
  const auto part = std::find_if(mesh.parts.begin(), mesh.parts.end(), [&](const Part& one) {
    return id >= one.first && id - one.first < one.count;
  });
  return part == mesh.parts.end() ? "scene" : part->name;
}

std::string part_name(std::size_t part) {
  return part == kAcrossParts ? "across" : std::to_string(part + 1);
}

std::vector<TriangleId> triangles_of(const Quarters& quarters, std::size_t part) {
  std::vector<TriangleId> ids;
  for (TriangleId id = 0; id < quarters.part.size(); ++id) {
    if (quarters.part[id] == part) {
      ids.push_back(id);
    }
  }
  return ids;
}

/// An object of the file, as far as it lies in part 1.
struct PlacedObject {
  std::string name;
  std::vector<TriangleId> triangles = {};
};

/// Most stages of figure 4.39 that are drawn; the last holds all objects.
constexpr std::size_t kDrawnStages = 4;

std::vector<PlacedObject> objects_of_part_1(const Mesh& mesh, const Quarters& quarters) {
  std::vector<PlacedObject> objects;
  std::map<std::string, std::size_t> places;
  for (const TriangleId id : triangles_of(quarters, 0)) {
    const std::string name = object_of(mesh, id);
    const auto [place, added] = places.try_emplace(name, objects.size());
    if (added) {
      objects.push_back({name});
    }
    objects[place->second].triangles.push_back(id);
  }
  return objects;
}

Table parts_table(std::span<const Model> scenes) {
  Table table{.id = "figure_4_40_parts",
              .caption =
                  "Triangles of the scenes by part: quarters, 1 at the least x and y, 2 at "
                  "the greatest x, 3 at the greatest y, 4 at both; across: in more than "
                  "one." +
                  note_on_stand_ins(scenes),
              .columns = {{"model"}, {"part"}, {"width_x"}, {"width_y"}, {"triangles"}}};
  for (const Model& scene : scenes) {
    const Quarters quarters = quarters_of(*scene.mesh);
    for (std::size_t part = 0; part <= kAcrossParts; ++part) {
      table.rows.push_back({scene.name, part_name(part),
                            part == kAcrossParts ? Cell{} : Cell{0.5 * quarters.extent.x},
                            part == kAcrossParts ? Cell{} : Cell{0.5 * quarters.extent.y},
                            count_cell(triangles_of(quarters, part).size())});
    }
  }
  return table;
}

}  // namespace

Result figure_4_39(const Context& context) {
  const Model& scene = context.models.scenes.front();
  const Mesh& mesh = *scene.mesh;
  const Quarters quarters = quarters_of(mesh);
  Table table{.id = "figure_4_39_objects",
              .caption = "Part 1 of the scene, object by object in the order of the file." +
                         note_on_stand_ins(std::span(&scene, 1)),
              .columns = {{"object"}, {"triangles"}, {"so_far"}}};
  Drawing drawing{.title = fmt::format("Part 1 of {}, put together", short_title(scene)),
                  .view = axonometric(UpAxis::z)};
  const std::vector<PlacedObject> objects = objects_of_part_1(mesh, quarters);
  std::vector<TriangleId> placed;
  std::vector<Mesh> stages;
  stages.reserve(kDrawnStages);
  std::string alt;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    placed.insert(placed.end(), objects[k].triangles.begin(), objects[k].triangles.end());
    table.rows.push_back(
        {objects[k].name, count_cell(objects[k].triangles.size()), count_cell(placed.size())});
    if (k + 1 < kDrawnStages || k + 1 == objects.size()) {
      stages.push_back(some_of(mesh, placed));
      drawing.panels.push_back({.title = k == 0 ? objects[k].name
                                         : k < kDrawnStages
                                             ? "with " + objects[k].name
                                             : fmt::format("with all {} objects", objects.size()),
                                .note = fmt::format("{} triangles", words(placed.size())),
                                .meshes = {{.mesh = &stages.back()}}});
      alt += fmt::format("{}: {}. ", drawing.panels.back().title, drawing.panels.back().note);
    }
  }
  Result result{.tables = {std::move(table)},
                .remarks = {"The scene of the thesis was put together by hand. What lies in more "
                            "than one part, such as long roads, is not in part 1."}};
  if (!objects.empty()) {
    result.figures = {{.id = "figure_4_39",
                       .caption = fmt::format("A part of {:.4g} by {:.4g} of the scene, put "
                                              "together object by object.",
                                              0.5 * quarters.extent.x, 0.5 * quarters.extent.y),
                       .svg = draw(drawing),
                       .alt = alt}};
  }
  return result;
}

Result figure_4_40(const Context& context) {
  const std::vector<Model>& scenes = context.models.scenes;
  const Mesh& mesh = *scenes.front().mesh;
  const Quarters quarters = quarters_of(mesh);
  Drawing drawing{.title = fmt::format("Part 1 of {}", short_title(scenes.front())),
                  .view = flat_view(),
                  .columns = 2,
                  .same_scale = false};
  drawing.keys = {{KeyKind::fill, 5, "part 1"}, {KeyKind::fill, kClay, "all else"}};
  Panel plan{.title = "The whole, from above",
             .note = fmt::format("{} triangles", words(mesh.triangles.size())),
             .meshes = {{.mesh = &mesh}}};
  for (const std::size_t part : quarters.part) {
    plan.meshes[0].colors.push_back(part == 0 ? 5 : kClay);
  }
  const Mesh first = some_of(mesh, triangles_of(quarters, 0));
  Panel alone{.title = "Part 1, from above",
              .note = fmt::format("{} triangles", words(first.triangles.size())),
              .meshes = {{.mesh = &first}}};
  std::string alt = fmt::format("{}: {}. {}: {}.", plan.title, plan.note, alone.title, alone.note);
  drawing.panels = {std::move(plan)};
  if (!first.triangles.empty()) {
    drawing.panels.push_back(std::move(alone));
  }
  return {
      .tables = {parts_table(scenes)},
      .figures = {{.id = "figure_4_40",
                   .caption = fmt::format("The scene is {:.4g} by {:.4g}, of four parts; part 1 "
                                          "is the one at the least x and y.",
                                          quarters.extent.x, quarters.extent.y),
                   .svg = draw(drawing),
                   .alt = alt}},
      .remarks = {"Which part the thesis calls part 1 was not available to us."}};
}

}  // namespace soms::reproduce
