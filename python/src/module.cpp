// The module soms._soms.
#include "python/src/call.h"
#include "python/src/errors.h"
#include "python/src/function.h"

// What the module is made of, in this order: a topic is bound by bind_TOPIC, in a file of its own.
// clang-format off
#define SOMS_TOPICS(topic) \
  topic(poses) \
  topic(georeferences) \
  topic(meshes) \
  topic(shapes) \
  topic(tiles) \
  topic(files) \
  topic(generated) \
  topic(answers) \
  topic(overlap) \
  topic(self_overlap) \
  topic(distance) \
  topic(within) \
  topic(rigid_motions) \
  topic(first_contact) \
  topic(solid) \
  topic(contains) \
  topic(closest) \
  topic(signed_distance) \
  topic(winding) \
  topic(rays) \
  topic(scene) \
  topic(contacts) \
  topic(body_index) \
  topic(recordings) \
  topic(pages) \
  topic(part_bodies) \
  topic(clash) \
  topic(robots) \
  topic(robot_model) \
  topic(robot_contacts) \
  topic(robot_path)
// clang-format on
#define SOMS_DECLARE(topic) void bind_##topic(pybind11::module_& module);
#define SOMS_BIND(topic) bind_##topic(module);

namespace soms::python {
SOMS_TOPICS(SOMS_DECLARE)
}  // namespace soms::python

PYBIND11_MODULE(_soms, module) {
  using namespace soms::python;
  pybind11::options options;
  options.disable_function_signatures();  // each docstring begins with a readable one
  module.doc() = "Exact collision queries on triangle meshes: the compiled part of soms.";
  module.attr("__version__") = SOMS_PYTHON_VERSION;
  translate_errors();
  prepare_calls();
  SOMS_TOPICS(SOMS_BIND)
  name_functions(module);
}

#undef SOMS_TOPICS
#undef SOMS_DECLARE
#undef SOMS_BIND
