#include "python/src/scene/bodies.h"

#include "python/src/arrays.h"
#include "python/src/call.h"

#include <utility>

namespace soms::python {

std::shared_ptr<Mesh> mesh_of_arrays(py::handle vertices, py::handle triangles) {
  auto mesh = std::make_shared<Mesh>();
  mesh->vertices = points_of(vertices, "vertices").copied();
  mesh->triangles = triangles_of(triangles);
  return run(Work::many, 1, py::none(), [&](const Limits&) {
    check(*mesh);
    return mesh;
  });
}

std::shared_ptr<const Mesh> mesh_of(py::handle given, const char* what) {
  if (inside<Mesh>(given) != nullptr) {
    return given.cast<std::shared_ptr<Mesh>>();
  }
  for (const char* const name : {"faces", "triangles"}) {
    if (py::hasattr(given, "vertices") && py::hasattr(given, name)) {
      return mesh_of_arrays(given.attr("vertices"), given.attr(name));
    }
  }
  throw usage(std::string(what) + ": an object of type " + Py_TYPE(given.ptr())->tp_name,
              "give a Body, Shape or Mesh, or an object with vertices and faces");
}

Shape shape_of(py::handle given, const char* what, int threads) {
  if (const Shape* const shape = inside<Shape>(given)) {
    return *shape;
  }
  auto mesh = mesh_of(given, what);
  return run(Work::many, threads, py::none(),
             [&](const Limits& limits) { return Shape(std::move(mesh), {}, limits); });
}

BodyArgument::BodyArgument(py::handle given, const char* what, int threads)
    : body_(inside<Body>(given)) {
  if (body_ == nullptr) {
    made_.emplace(shape_of(given, what, threads));
    body_ = &*made_;
  }
}

}  // namespace soms::python
