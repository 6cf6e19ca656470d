// Points and rays of a scene.
#include "soms/query/print.h"
#include "soms/scene/print.h"

#include "python/src/described.h"
#include "python/src/scene/many_bodies.h"
#include "python/src/scene/scene.h"
#include "python/src/scene/scene_columns.h"

#include <optional>
#include <utility>

namespace soms::python {

py::array Column<std::optional<SceneBody>>::make(
    const std::vector<std::optional<SceneBody>>& values, py::handle) {
  py::array_t<std::int64_t> array({static_cast<py::ssize_t>(values.size()), py::ssize_t{2}});
  std::int64_t* to = array.mutable_data();
  for (const auto& value : values) {
    *to++ = value ? static_cast<std::int64_t>(value->kind) : -1;
    *to++ = value ? std::int64_t{value->id} : -1;
  }
  return array;
}

namespace {

using Ignored = std::optional<std::pair<py::object, std::uint32_t>>;

SceneFilter filter_of(bool environment, bool movers, Ignored ignored) {
  SceneFilter filter{.environment = environment, .movers = movers};
  if (ignored) {
    filter.except = SceneBody{enum_of<SceneBodyKind>(ignored->first, "ignore"), ignored->second};
  }
  return filter;
}

void bind_scene_answers(py::module_& module) {
  bind_answers_of<SceneClosest>(module);
  bind_answers_of<SceneHit>(module);
  bind_answer<SceneAllHits>(module);
}

}  // namespace

void bind_scene_queries(py::module_& module, SceneClass& scene) {
  bind_scene_answers(module);
  ManyBodies many(
      scene, &filter_of,
      {py::arg("environment") = true, py::arg("movers") = true, py::arg("ignore") = py::none()},
      {"environment=True, movers=True, ignore=None, ",
       "\n\nenvironment, movers: which bodies take part. ignore: (kind, number) of a body that "
       "does "
       "not, such as\n('mover', 3); with skip, only that triangle of it does not. Others: as for "
       "the function of this name."});
  many.bind_closest("SceneClosest", "SceneClosestBatch");
  many.bind_all_rays("SceneHit", "SceneHitBatch", "SceneAllHits");
}

}  // namespace soms::python
