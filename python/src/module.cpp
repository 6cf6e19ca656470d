// The module soms._soms.
#include "python/src/bind.h"
#include "python/src/call.h"
#include "python/src/enums.h"
#include "python/src/errors.h"
#include "python/src/function.h"

PYBIND11_MODULE(_soms, module) {
  using namespace soms::python;
  pybind11::options options;
  options.disable_function_signatures();  // each docstring begins with a readable one
  module.doc() = "Exact collision queries on triangle meshes: the compiled part of soms.";
  module.attr("__version__") = SOMS_PYTHON_VERSION;
  translate_errors();
  load_enums();
  prepare_calls();
  bind_poses(module);
  bind_georeferences(module);
  bind_meshes(module);
  bind_shapes(module);
  bind_tiles(module);
  bind_files(module);
  bind_generated(module);
  bind_answers(module);
  bind_overlap(module);
  bind_distance(module);
  bind_within(module);
  bind_solid(module);
  bind_contains(module);
  bind_closest(module);
  bind_signed_distance(module);
  bind_winding(module);
  bind_rays(module);
  bind_scene(module);
  bind_contacts(module);
  bind_body_index(module);
  bind_recordings(module);
  bind_pages(module);
  bind_part_bodies(module);
  bind_clash(module);
  bind_robots(module);
  bind_robot_model(module);
  name_functions(module);
}
