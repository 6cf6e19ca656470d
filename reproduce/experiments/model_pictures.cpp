// Figures 3.7 and 3.9: the objects and the scenes.
#include "reproduce/drawing.h"
#include "reproduce/experiments/experiments.h"

#include <fmt/format.h>

namespace soms::reproduce {

namespace {

Figure models_figure(const std::string& id, const std::string& title, const std::string& caption,
                     const std::vector<Model>& models, UpAxis up, int columns) {
  Drawing drawing{.title = title, .view = axonometric(up), .columns = columns};
  drawing.same_scale = false;
  for (const Model& model : models) {
    const Mesh& mesh = *model.mesh;
    drawing.panels.push_back(
        {.title = model.title.empty() ? model.name : model.title,
         .note = fmt::format("{} triangles, {} vertices{}",
                             to_text(static_cast<std::int64_t>(mesh.triangles.size())),
                             to_text(static_cast<std::int64_t>(mesh.vertices.size())),
                             model.stand_in ? "; a stand-in" : ""),
         .meshes = {{.mesh = &mesh}}});
  }
  std::string alt;
  for (const Panel& panel : drawing.panels) {
    alt += fmt::format("{}: {}. ", panel.title, panel.note);
  }
  return {.id = id, .caption = caption, .svg = draw(drawing), .alt = alt};
}

}  // namespace

Result figure_3_7(const Context& context) {
  return {
      .figures = {models_figure("figure_3_7", "The objects",
                                "The objects as they are stored, y upwards, each at its own scale.",
                                context.models.objects, UpAxis::y, 2)}};
}

Result figure_3_9(const Context& context) {
  return {.figures = {models_figure("figure_3_9", "The urban scenes",
                                    "The urban scenes from above, each at its own scale.",
                                    context.models.scenes, UpAxis::z, 1)}};
}

}  // namespace soms::reproduce
