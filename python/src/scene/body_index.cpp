// Many bodies at rest: which is nearest to a point, and which does a ray hit first?
#include "soms/scene/body_index.h"

#include "soms/query/print.h"
#include "soms/scene/print.h"

#include "python/src/described.h"
#include "python/src/scene/bodies.h"
#include "python/src/scene/many_bodies.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kIndexDoc = R"(BodyIndex(bodies)

Many bodies at rest, and an index of their boxes: which is nearest to a point, and which does a ray hit
first? A body's number is its place in bodies. It does not change, and any number of threads may use
it; a Scene answers the same of bodies that move.

bodies: each a Body, Shape or Mesh, or an object with vertices and faces. given(number) returns the very
object. Raises Error of kind usage, not_rigid, not_finite, out_of_range.
Cost: O(n log n) for n bodies; a query typically O(log n), and one query for each body that is as near
as the nearest.)";

/// A BodyIndex, which remembers the bodies as they were given.
struct HeldIndex {
  BodyIndex index;
  std::vector<py::object> given;

  [[nodiscard]] const BodyIndex& queried() const { return index; }
};

/// It does not change: it may be in use by anybody.
const HeldIndex& use(HeldIndex& held) {
  return held;
}

HeldIndex held_index(const py::iterable& bodies) {
  HeldIndex held;
  std::vector<Body> all;
  for (const py::handle& one : bodies) {
    const std::string what = "bodies[" + std::to_string(all.size()) + "]";
    all.push_back(BodyArgument(one, what.c_str()).get());
    held.given.push_back(py::reinterpret_borrow<py::object>(one));
  }
  held.index = BodyIndex(all);
  return held;
}

BodyFilter index_filter(std::optional<std::uint32_t> ignored) {
  return {.except = ignored};
}

void bind_index_answers(py::module_& module) {
  bind_answers_of<BodyClosest>(module);
  bind_answers_of<BodyHit>(module);
  bind_answer<BodyAllHits>(module);
}

}  // namespace

void bind_body_index(py::module_& module) {
  bind_index_answers(module);
  py::class_<HeldIndex> index(module, "BodyIndex", kIndexDoc);
  index.def(py::init(&held_index), py::arg("bodies"));
  index.def("__len__", [](const HeldIndex& held) { return held.index.size(); });
  index.def(
      "body", [](const HeldIndex& held, std::uint32_t number) { return held.index.body(number); },
      py::arg("number"), "body(number) -> Body");
  index.def(
      "given",
      [](const HeldIndex& held, std::uint32_t number) {
        static_cast<void>(held.index.body(number));  // refuses one that is not there
        return held.given[number];
      },
      py::arg("number"), "given(number)\n\nThe very object that has this number.");
  index.def_property_readonly(
      "memory", [](const HeldIndex& held) { return held.index.memory(); },
      "Bytes held, shapes not counted.");
  ManyBodies many(index, &index_filter, {py::arg("ignore") = py::none()},
                  {"ignore=None, ",
                   "\n\nignore: the number of a body that does not take part; with skip, only that "
                   "triangle of it does\nnot. Others: as for the function of this name."});
  many.bind_closest("BodyClosest", "BodyClosestBatch");
  many.bind_all_rays("BodyHit", "BodyHitBatch", "BodyAllHits");
  index.def("__repr__", [](const HeldIndex& held) {
    return "BodyIndex{" + std::to_string(held.index.size()) + " bodies}";
  });
  index.def(py::pickle([](const HeldIndex& held) { return py::make_tuple(py::cast(held.given)); },
                       [](const py::tuple& state) { return held_index(state[0]); }));
}

}  // namespace soms::python
