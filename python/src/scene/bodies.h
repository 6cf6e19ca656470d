/// \file
/// Arguments that stand for bodies: Body, Shape, Mesh, and foreign meshes by their arrays.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/body.h"

#include "python/src/errors.h"
#include "python/src/objects.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

namespace soms::python {

/// A mesh of arrays, checked. \shape `vertices` (n, 3), `triangles` (m, 3).
/// \errors ErrorKind::usage, out_of_range, not_finite.
[[nodiscard]] std::shared_ptr<Mesh> mesh_of_arrays(py::handle vertices, py::handle triangles);

/// A Mesh, or an object that has `vertices` and `faces` (or `triangles`), whose arrays are copied.
/// \errors ErrorKind::usage for anything else; `what` is the argument.
[[nodiscard]] std::shared_ptr<const Mesh> mesh_of(py::handle given, const char* what);

/// A Shape, or what `mesh_of` takes, which is built with default options.
[[nodiscard]] Shape shape_of(py::handle given, const char* what, int threads = 1);

/// A body that is given, or one made for the call.
class BodyArgument {
 public:
  /// A Body, or what `shape_of` takes, unmoved.
  BodyArgument(py::handle given, const char* what, int threads = 1);
  BodyArgument(const BodyArgument&) = delete;
  BodyArgument& operator=(const BodyArgument&) = delete;

  [[nodiscard]] const Body& get() const { return *body_; }

 private:
  std::optional<Body> made_;
  const Body* body_;  ///< kept by the caller's arguments, or `made_`
};

}  // namespace soms::python
