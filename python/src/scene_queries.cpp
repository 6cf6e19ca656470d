// Points and rays of a scene.
#include "soms/query/print.h"
#include "soms/scene/print.h"

#include "python/src/call.h"
#include "python/src/closest_fields.h"
#include "python/src/point_query.h"
#include "python/src/ray_arguments.h"
#include "python/src/scene.h"
#include "python/src/scene_columns.h"

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>

namespace soms::python {

py::dtype RowType<SceneBody>::get() {
  return structured(
      {{"kind", "u1", offsetof(SceneBody, kind)}, {"number", "u4", offsetof(SceneBody, id)}},
      sizeof(SceneBody));
}

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

constexpr const char* kFilterDoc = R"(

environment, movers: which bodies take part. ignore: (kind, number) of a body that does not, such as
('mover', 3); with skip, only that triangle of it does not. Others: as for the function of this name.)";

using Ignored = std::optional<std::pair<py::object, std::uint32_t>>;

SceneFilter filter_of(bool environment, bool movers, const Ignored& ignored) {
  SceneFilter filter{.environment = environment, .movers = movers};
  if (ignored) {
    filter.except = SceneBody{enum_of<SceneBodyKind>(ignored->first, "ignore"), ignored->second};
  }
  return filter;
}

/// (kind, number), or None.
template <class T>
py::object body_of(const T& answer) {
  return answer.body ? py::object(py::make_tuple(member(answer.body->kind), answer.body->id))
                     : py::none();
}

py::object closest_point(HeldScene& held, const py::object& points, double at_most,
                         bool environment, bool movers, const Ignored& ignored,
                         std::optional<double> seconds, int threads, const py::object& progress) {
  const SceneUse use(held);
  const ClosestOptions options{.at_most = at_most, .deadline = deadline_in(seconds)};
  const SceneFilter filter = filter_of(environment, movers, ignored);
  return answer_points(points, threads, progress,
                       [&](const Parallel& parallel, const auto& places) {
                         return use.scene().closest(places, options, filter, parallel);
                       });
}

/// Binds `query(scene, one or more lines, options, filter...)` as a method.
template <class Query>
void def_scene_rays(SceneClass& scene, const char* name, const Query& query, const char* what) {
  const std::string doc = std::string(name) +
                          "(origins, directions=None, *, ends=None, lengths=inf, skip=None, "
                          "environment=True, movers=True, ignore=None, seconds=None, threads=1, "
                          "progress=None)\n\n" +
                          what + kFilterDoc;
  scene.def(
      name,
      [query](HeldScene& held, const py::object& origins, const py::object& directions,
              const py::object& ends, const py::object& lengths, const py::object& skip,
              bool environment, bool movers, const Ignored& ignored, std::optional<double> seconds,
              int threads, const py::object& progress) {
        const SceneUse use(held);
        const RayOptions options = ray_options(skip, seconds);
        const SceneFilter filter = filter_of(environment, movers, ignored);
        return answer_rays(rays_of(origins, directions, ends, lengths), threads, progress,
                           [&](const auto& lines, const auto&... parallel) {
                             return query(std::as_const(use.scene()), lines, options, filter,
                                          parallel...);
                           });
      },
      py::arg("origins"), py::arg("directions") = py::none(), py::kw_only(),
      py::arg("ends") = py::none(), py::arg("lengths") = Ray{}.length, py::arg("skip") = py::none(),
      py::arg("environment") = true, py::arg("movers") = true, py::arg("ignore") = py::none(),
      py::arg("seconds") = py::none(), py::arg("threads") = 1, py::arg("progress") = py::none(),
      doc.c_str());
}

void bind_scene_answers(py::module_& module) {
  const char* const body = "(kind, number) of the body, or None.";
  const char* const bodies = "(n, 2) int64: kind and number of the body, -1, -1 for none.";
  AnswerClass<SceneClosest> closest(module, "SceneClosest", "The nearest point of a scene.");
  closest_fields(closest);
  closest.derived("body", &body_of<SceneClosest>, body);
  AnswerClass<SceneClosestBatch> closests(module, "SceneClosestBatch",
                                          "The nearest points of a scene to n points.");
  closest_columns(closests);
  closests.column("body", &SceneClosestBatch::body, bodies);
  AnswerClass<SceneHit> hit(module, "SceneHit", "The first hit of a ray in a scene.");
  hit_fields(hit);
  hit.derived("body", &body_of<SceneHit>, body);
  AnswerClass<SceneHitBatch> hits(module, "SceneHitBatch", "The first hits of n rays in a scene.");
  hit_columns(hits);
  hits.column("body", &SceneHitBatch::body, bodies);
  AnswerClass<SceneAllHits> all(module, "SceneAllHits", "All places where n rays meet a scene.");
  all_hits_columns(all);
  all.column("body", &SceneAllHits::body, "(m,) with fields kind and number, of each crossing.");
}

}  // namespace

void bind_scene_queries(py::module_& module, SceneClass& scene) {
  bind_scene_answers(module);
  const std::string doc =
      std::string(
          "closest(points, *, at_most=inf, environment=True, movers=True, ignore=None, "
          "seconds=None, threads=1, progress=None)\n\nThe nearest point of all bodies. "
          "Returns SceneClosest, or SceneClosestBatch for n points.") +
      kFilterDoc;
  scene.def("closest", &closest_point, py::arg("points"), py::kw_only(),
            py::arg("at_most") = ClosestOptions{}.at_most, py::arg("environment") = true,
            py::arg("movers") = true, py::arg("ignore") = py::none(),
            py::arg("seconds") = py::none(), py::arg("threads") = 1,
            py::arg("progress") = py::none(), doc.c_str());
  def_scene_rays(
      scene, "closest_hit", [](const Scene& s, const auto&... of) { return s.closest_hit(of...); },
      "The first point of all bodies on a ray. Returns SceneHit, or SceneHitBatch for n rays.");
  def_scene_rays(
      scene, "any_hit", [](const Scene& s, const auto&... of) { return s.any_hit(of...); },
      "Does a ray hit any body? Returns AnyHit, or AnyHitBatch for n rays.");
  def_scene_rays(
      scene, "all_hits",
      [](const Scene& s, const auto& lines, const auto&... of) {
        return s.all_hits(lines_of(lines), of...);
      },
      "All places where rays meet bodies. Returns SceneAllHits.");
}

}  // namespace soms::python
