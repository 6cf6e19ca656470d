// The parts of models: class PartBodies.
#include "python/src/part_set.h"

#include "soms/clash/part_keys.h"
#include "soms/clash/print.h"
#include "soms/geometry/parts_of.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/objects.h"
#include "python/src/poses.h"
#include "python/src/scene/bodies.h"
#include "python/src/scene/record_columns.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <iterator>
#include <utility>

namespace soms::python {

namespace {

using PartsClass = py::class_<PartSet, SharedParts>;

constexpr const char* kPartsDoc = R"(PartBodies(models, *, threads=1, progress=None)

The parts of one or several models, each as a body of its own, as clash compares them: every part of
Mesh.parts that is the innermost of a triangle, and last the triangles that no part holds. Build it
once where you call more than once. It does not change; parts are numbered from 0 over all models.

models: a Mesh, Shape or Body (at its pose), an object with vertices and faces, or a list of them.

Raises Error of kind usage; not_rigid, out_of_range for a pose. Cost: O(n log n) for n triangles.
Pickling keeps meshes and poses, and divides again.)";

PosedMesh posed_mesh_of(py::handle given, const char* what) {
  if (const Body* const body = inside<Body>(given)) {
    return {body->shape.shared_mesh(), body->pose};
  }
  if (const Shape* const shape = inside<Shape>(given)) {
    return {shape->shared_mesh()};
  }
  return {mesh_of(given, what)};
}

SharedParts divided_now(std::vector<PosedMesh> models, int threads, const py::object& progress) {
  return run(Work::many, threads, progress,
             [&](const Limits& limits) { return divided_models(std::move(models), limits); });
}

const PartBody& part_at(const PartSet& set, std::size_t number) {
  if (number >= set.parts.size()) {
    throw py::index_error("part " + std::to_string(number) + " of " +
                          std::to_string(set.parts.size()));
  }
  return set.parts[number];
}

/// Texts of the parts of the file; empty for what no part holds.
std::vector<Text> file_texts(const PartSet& set, std::string Part::*place) {
  std::vector<Text> texts;
  for (std::size_t k = 0; k < set.parts.size(); ++k) {
    const std::uint32_t part = set.parts[k].part;
    texts.push_back({part == Part::kNoParent ? std::string() : set.mesh_of(k).parts[part].*place});
  }
  return texts;
}

std::vector<Text> names_of(const PartSet& set) {
  std::vector<Text> names;
  for (std::size_t k = 0; k < set.parts.size(); ++k) {
    const Mesh& mesh = set.mesh_of(k);
    std::string name = part_text(mesh, set.parts[k].part);
    for (const std::uint32_t other : set.parts[k].joined) {
      name += " + " + part_text(mesh, other);
    }
    names.push_back({std::move(name)});
  }
  return names;
}

/// Numbers of parts, -1 for the triangles that no part holds.
py::list joined_of(const PartSet& set) {
  py::list all;
  for (const PartBody& part : set.parts) {
    py::list others;
    for (const std::uint32_t other : part.joined) {
      others.append(other == Part::kNoParent ? std::int64_t{-1} : std::int64_t{other});
    }
    all.append(std::move(others));
  }
  return all;
}

py::array bounds_of(const PartSet& set) {
  const auto count = static_cast<py::ssize_t>(set.parts.size());
  py::array_t<double> bounds({count, py::ssize_t{2}, py::ssize_t{3}});
  double* to = bounds.mutable_data();
  for (const PartBody& part : set.parts) {
    const Box box = part.box();
    for (const Vec3& corner : {box.lower, box.upper}) {
      for (const double x : {corner.x, corner.y, corner.z}) {
        *to++ = x;
      }
    }
  }
  return bounds;
}

void bind_part_columns(PartsClass& parts) {
  def_property(
      parts, "model",
      [](const py::object& self) { return column_of(self.cast<const PartSet&>().model, self); },
      "(n,) uint32: the model of each part, by its place in what was given.");
  def_property(
      parts, "part",
      [](const py::object& self) {
        return computed_column<std::int64_t>(
            self.cast<const PartSet&>().parts, [](const PartBody& part) {
              return part.part == Part::kNoParent ? -1 : std::int64_t{part.part};
            });
      },
      "(n,) int64: its place in Mesh.parts, -1 for the triangles that no part holds.");
  def_property(
      parts, "closed",
      [](const py::object& self) {
        return computed_column<bool>(self.cast<const PartSet&>().parts,
                                     [](const PartBody& part) { return part.closed.has_value(); });
      },
      "(n,) bool: whether its surface is closed, decided exactly.");
  def_property(
      parts, "odd_edges",
      [](const py::object& self) {
        return field_column(self.cast<const PartSet&>().parts, &PartBody::odd_edges, self);
      },
      "(n,) uint64: edges of an odd number of triangles; 0 of closed ones.");
  def_property(
      parts, "bounds",
      [](const py::object& self) { return bounds_of(self.cast<const PartSet&>()); },
      "(n, 2, 3): lower and upper corner of the box of each part, in world.");
  parts.def_property_readonly("names", &names_of,
                              "A list of str: the names around the part and its own, as "
                              "'Level 1/Slab'; the mesh's source for triangles of no part. Of a "
                              "body of several parts, all, with ' + ' between.");
  parts.def_property_readonly("joined", &joined_of,
                              "A list of lists of int: the other parts of each body, as part has "
                              "the first: parts that close each other are one body.");
  parts.def_property_readonly(
      "ids", [](const PartSet& set) { return file_texts(set, &Part::id); },
      "A list of str: the id that the file gives the part, or an empty text.");
  parts.def_property_readonly(
      "types", [](const PartSet& set) { return file_texts(set, &Part::type); },
      "A list of str: the kind of object, or an empty text.");
}

py::tuple parts_state(const PartSet& set) {
  py::list models;
  for (const PosedMesh& model : set.models) {
    models.append(py::make_tuple(std::const_pointer_cast<Mesh>(model.mesh), model.pose));
  }
  return py::make_tuple(models);
}

SharedParts parts_from(const py::tuple& state) {
  std::vector<PosedMesh> models;
  for (const py::handle one : state[0].cast<py::list>()) {
    const auto pair = one.cast<py::tuple>();
    models.push_back({pair[0].cast<std::shared_ptr<Mesh>>(), pair[1].cast<Pose>()});
  }
  return divided_now(std::move(models), 1, py::none());
}

}  // namespace

std::vector<PosedMesh> posed_meshes_of(py::handle given, const char* what) {
  std::vector<PosedMesh> models;
  if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
    for (const py::handle one : given) {
      models.push_back(posed_mesh_of(one, what));
    }
  } else {
    models.push_back(posed_mesh_of(given, what));
  }
  return models;
}

std::string part_text(const Mesh& mesh, std::uint32_t part) {
  if (part == Part::kNoParent) {
    return mesh.source;
  }
  std::string text;
  const std::vector<std::string> path = part_path(mesh, part);
  for (std::size_t k = 0; k < path.size(); ++k) {
    const bool is_last = k + 1 == path.size();
    text += k == 0 ? "" : "/";
    text += !path[k].empty() ? path[k] : is_last ? "part " + std::to_string(part) : "...";
  }
  return text;
}

SharedParts divided_models(std::vector<PosedMesh> models, const Limits& limits) {
  auto set = std::make_shared<PartSet>();
  set->models = std::move(models);
  for (std::uint32_t k = 0; k < set->models.size(); ++k) {
    const PosedMesh& model = set->models[k];
    std::vector<PartBody> parts = part_bodies(*model.mesh, model.pose, limits);
    set->model.insert(set->model.end(), parts.size(), k);
    std::move(parts.begin(), parts.end(), std::back_inserter(set->parts));
  }
  return set;
}

SharedParts parts_argument(py::handle given, const char* what, int threads) {
  if (inside<PartSet>(given) != nullptr) {
    return given.cast<SharedParts>();
  }
  return divided_now(posed_meshes_of(given, what), threads, py::none());
}

void bind_part_bodies(py::module_& module) {
  PartsClass parts(module, "PartBodies", kPartsDoc);
  parts.def(py::init([](const py::object& models, int threads, const py::object& progress) {
              return divided_now(posed_meshes_of(models, "models"), threads, progress);
            }),
            py::arg("models"), py::kw_only(), py::arg("threads") = 1,
            py::arg("progress") = py::none());
  bind_part_columns(parts);
  parts.def(
      "body", [](const PartSet& set, std::size_t number) { return part_at(set, number).body; },
      py::arg("number"), "body(number) -> Body\n\nA part as a body; its name is that of the part.");
  parts.def(
      "triangles",
      [](const py::object& self, std::size_t number) {
        return column_of(part_at(self.cast<const PartSet&>(), number).triangles, self);
      },
      py::arg("number"),
      "triangles(number) -> numpy.ndarray\n\n(m,) uint32: triangle i of body(number) is "
      "triangles(number)[i] of its mesh.");
  parts.def("__len__", [](const PartSet& set) { return set.parts.size(); });
  parts.def(
      "__eq__",
      [](const PartSet& a, const PartSet& b) { return a.parts == b.parts && a.model == b.model; },
      py::is_operator());
  parts.attr("__hash__") = py::none();
  parts.def("__repr__", [](const PartSet& set) {
    return "PartBodies{" + std::to_string(set.parts.size()) + " parts of " +
           std::to_string(set.models.size()) + " models}";
  });
  parts.def(py::pickle(&parts_state, &parts_from));
}

}  // namespace soms::python
