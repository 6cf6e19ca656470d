/// \file
/// What the module is made of: each function binds one topic.
#pragma once

#include <pybind11/pybind11.h>

namespace soms::python {

void bind_poses(pybind11::module_& module);
void bind_georeferences(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_shapes(pybind11::module_& module);
void bind_tiles(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_generated(pybind11::module_& module);
void bind_answers(pybind11::module_& module);
void bind_overlap(pybind11::module_& module);
void bind_distance(pybind11::module_& module);
void bind_within(pybind11::module_& module);
void bind_solid(pybind11::module_& module);
void bind_contains(pybind11::module_& module);
void bind_closest(pybind11::module_& module);
void bind_signed_distance(pybind11::module_& module);
void bind_winding(pybind11::module_& module);
void bind_rays(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_contacts(pybind11::module_& module);
void bind_body_index(pybind11::module_& module);
void bind_recordings(pybind11::module_& module);
void bind_pages(pybind11::module_& module);
void bind_part_bodies(pybind11::module_& module);
void bind_clash(pybind11::module_& module);
void bind_robots(pybind11::module_& module);
void bind_robot_model(pybind11::module_& module);

}  // namespace soms::python
