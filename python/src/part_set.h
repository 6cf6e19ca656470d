/// \file
/// The parts of one or several models, as clash lists and robots' cells take them.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/clash/part_bodies.h"
#include "soms/geometry/mesh.h"

#include "python/src/errors.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace soms::python {

/// A mesh and its place.
struct PosedMesh {
  std::shared_ptr<const Mesh> mesh;
  Pose pose = {};
};

/// A Body, Shape or Mesh (or an object with vertices and faces), or a list or tuple of them.
/// \errors ErrorKind::usage for anything else; `what` is the argument.
[[nodiscard]] std::vector<PosedMesh> posed_meshes_of(py::handle given, const char* what);

/// The names around a part and its own, with slashes between; "part 7" of one without a name, and
/// of no part the mesh's source.
[[nodiscard]] std::string part_text(const Mesh& mesh, std::uint32_t part);

/// The parts of models, each as a body.
struct PartSet {
  std::vector<PosedMesh> models;
  std::vector<PartBody> parts;       ///< of all models
  std::vector<std::uint32_t> model;  ///< of each part

  [[nodiscard]] const Mesh& mesh_of(std::size_t part) const { return *models[model[part]].mesh; }
};

using SharedParts = std::shared_ptr<PartSet>;

/// \errors As `part_bodies`.
[[nodiscard]] SharedParts divided_models(std::vector<PosedMesh> models, const Limits& limits);

/// A PartBodies, or what `posed_meshes_of` takes, which is divided for the call.
[[nodiscard]] SharedParts parts_argument(py::handle given, const char* what, int threads);

}  // namespace soms::python
