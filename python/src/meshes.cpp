#include "soms/geometry/closedness.h"
#include "soms/geometry/defects.h"
#include "soms/geometry/mesh.h"
#include "soms/geometry/parts_of.h"
#include "soms/geometry/print.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/notebook.h"
#include "python/src/scene/bodies.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <numeric>

namespace soms::python {

namespace {

using MeshClass = py::class_<Mesh, std::shared_ptr<Mesh>>;

constexpr const char* kMeshDoc =
    R"(Mesh(vertices, triangles, parts=(), *, unit=0.0, up='unknown', source='', notes=(), file_faces=(),
     georeference=Georeference())

A triangle mesh as it is given: nothing is welded, moved or dropped. It does not change.

vertices: (n, 3) floats. triangles: (m, 3) integers from 0 on. parts: Part, each a run of triangles.
unit: meters a unit, 0 if unknown. up: 'unknown', 'x', 'y' or 'z'. georeference: where on the Earth
the numbers lie.

The arrays are copied. Raises Error of kind usage (shapes, types), out_of_range (an index below 0 or
beyond the vertices, a coordinate beyond 2^300), not_finite (a corner), bad_file (parts).)";

std::shared_ptr<Mesh> make_mesh(const py::object& vertices, const py::object& triangles,
                                std::vector<Part> parts, double unit, const py::object& up,
                                Text source, std::vector<Text> notes,
                                std::vector<std::uint32_t> file_faces, Georeference georeference) {
  if (!(unit >= 0 && std::isfinite(unit))) {
    throw usage("unit: " + std::to_string(unit), "give meters a unit, or 0 if they are unknown");
  }
  auto mesh = mesh_of_arrays(vertices, triangles);
  mesh->parts = std::move(parts);
  mesh->unit = unit;
  mesh->up = enum_of<UpAxis>(up, "up");
  mesh->source = std::move(source.bytes);
  mesh->notes = bytes_of_texts(std::move(notes));
  mesh->faces = std::move(file_faces);
  mesh->georeference = std::move(georeference);
  check(*mesh);
  return mesh;
}

py::array part_of_each(const Mesh& mesh, const py::object& given) {
  Extents shape{static_cast<py::ssize_t>(mesh.triangles.size())};
  std::vector<TriangleId> ids(mesh.triangles.size());
  if (given.is_none()) {
    std::iota(ids.begin(), ids.end(), 0U);
  } else {
    ids = ids_of(given, "triangles", shape);
  }
  const PartsOf parts(mesh);
  py::array_t<std::int64_t> found(shape);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] >= mesh.triangles.size()) {
      throw usage(
          "triangle " + std::to_string(ids[i]) + " of " + std::to_string(mesh.triangles.size()),
          "give numbers of triangles of this mesh");
    }
    const std::uint32_t part = parts(ids[i]);
    found.mutable_data()[i] = part == Part::kNoParent ? -1 : std::int64_t{part};
  }
  return found;
}

std::vector<Text> path_of_part(const Mesh& mesh, std::size_t part) {
  if (part >= mesh.parts.size()) {
    throw py::index_error("part " + std::to_string(part) + " of " +
                          std::to_string(mesh.parts.size()));
  }
  return texts_of(part_path(mesh, static_cast<std::uint32_t>(part)));
}

using AttributeList = std::vector<std::pair<Text, Text>>;

AttributeList attribute_list(const std::vector<Attribute>& attributes) {
  AttributeList list;
  for (const Attribute& attribute : attributes) {
    list.emplace_back(Text{attribute.name}, Text{attribute.value});
  }
  return list;
}

std::vector<Attribute> attributes_from(const AttributeList& list) {
  std::vector<Attribute> attributes;
  for (const auto& [name, value] : list) {
    attributes.push_back({name.bytes, value.bytes});
  }
  return attributes;
}

void bind_parts(py::module_& module) {
  py::class_<Part> part(
      module, "Part",
      R"(Part(name, first, count, parent=None, *, id='', type='', attributes=(), continues=None)

A named, contiguous run of triangles of a Mesh; parent: the index of the part around it. What the
file states about the object: its id, its type, and attributes as pairs (name, value) of text. An
object whose triangles do not follow each other is several runs; continues: the index of the first.)");
  part.def(py::init([](Text name, std::uint32_t first, std::uint32_t count,
                       std::optional<std::uint32_t> parent, Text id, Text type,
                       const AttributeList& attributes, std::optional<std::uint32_t> continues) {
             return Part{std::move(name.bytes),
                         parent.value_or(Part::kNoParent),
                         first,
                         count,
                         std::move(id.bytes),
                         std::move(type.bytes),
                         attributes_from(attributes),
                         continues.value_or(Part::kNoParent)};
           }),
           py::arg("name"), py::arg("first"), py::arg("count"), py::arg("parent") = py::none(),
           py::kw_only(), py::arg("id") = "", py::arg("type") = "",
           py::arg("attributes") = AttributeList(), py::arg("continues") = py::none());
  part.def_property_readonly(
      "name", [](const Part& p) { return Text{p.name}; }, "The name.");
  part.def_readonly("first", &Part::first, "The first triangle.");
  part.def_readonly("count", &Part::count, "The number of triangles.");
  part.def_property_readonly(
      "parent",
      [](const Part& p) {
        return p.parent == Part::kNoParent ? std::optional<std::uint32_t>() : p.parent;
      },
      "The index of the part around it, or None.");
  part.def_property_readonly(
      "id", [](const Part& p) { return Text{p.id}; },
      "The id that the file gives the object, or an empty text.");
  part.def_property_readonly(
      "type", [](const Part& p) { return Text{p.type}; }, "The kind of object, or an empty text.");
  part.def_property_readonly(
      "attributes", [](const Part& p) { return attribute_list(p.attributes); },
      "What the file states: pairs of name and value, as text.");
  part.def_property_readonly(
      "continues",
      [](const Part& p) {
        return p.continues == Part::kNoParent ? std::optional<std::uint32_t>() : p.continues;
      },
      "The index of the first run of the same object, or None.");
  part.def(
      "__eq__", [](const Part& a, const Part& b) { return a == b; }, py::is_operator());
  part.attr("__hash__") = py::none();
  part.def("__repr__", &printed<Part>);
  part.def(py::pickle(
      [](const Part& p) {
        return py::make_tuple(Text{p.name}, p.parent, p.first, p.count, Text{p.id}, Text{p.type},
                              attribute_list(p.attributes), p.continues);
      },
      [](const py::tuple& state) {
        return Part{state[0].cast<Text>().bytes,
                    state[1].cast<std::uint32_t>(),
                    state[2].cast<std::uint32_t>(),
                    state[3].cast<std::uint32_t>(),
                    state[4].cast<Text>().bytes,
                    state[5].cast<Text>().bytes,
                    attributes_from(state[6].cast<AttributeList>()),
                    state[7].cast<std::uint32_t>()};
      }));
}

void bind_columns(MeshClass& mesh) {
  const auto self_column = [&](const char* name, auto place, const char* doc) {
    mesh.def_property_readonly(
        name,
        [place](const py::object& self) {
          return column_of(self.cast<const Mesh&>().*place, self);
        },
        doc);
  };
  self_column("vertices", &Mesh::vertices, "(n, 3) float64, a view that cannot be written.");
  self_column("triangles", &Mesh::triangles, "(m, 3) uint32, a view that cannot be written.");
  self_column("faces", &Mesh::triangles, "The same as triangles, as other libraries call them.");
  self_column("file_faces", &Mesh::faces,
              "(m,) uint32: the face of the file for each triangle; empty if they are the same.");
  mesh.def_property_readonly(
      "bounds", [](const Mesh& m) { return array_of(bounds(m)); },
      "(2, 3): the lower and the upper corner of the box of all triangles.");
  mesh.def_property_readonly(
      "parts", [](const Mesh& m) { return m.parts; }, "A list of Part.");
  mesh.def_property_readonly(
      "up", [](const Mesh& m) { return member(m.up); }, "UpAxis that the file states.");
  mesh.def_readonly("unit", &Mesh::unit, "Meters a unit if the file says so, else 0.");
  mesh.def_readonly("georeference", &Mesh::georeference,
                    "Georeference: where on the Earth the numbers lie, if the file says so.");
  mesh.def_property_readonly(
      "source", [](const Mesh& m) { return Text{m.source}; },
      "The path of the file, or what made the mesh.");
  mesh.def_property_readonly(
      "notes", [](const Mesh& m) { return texts_of(m.notes); },
      "What the file holds that was not read or applied.");
}

/// What a mesh says of itself.
void bind_facts(MeshClass& mesh) {
  mesh.def("__len__", [](const Mesh& m) { return m.triangles.size(); });
  mesh.def(
      "__eq__", [](const Mesh& a, const Mesh& b) { return a == b; }, py::is_operator());
  mesh.attr("__hash__") = py::none();
  mesh.def("__repr__", &printed<Mesh>);
  mesh.def("part_of", &part_of_each, py::arg("triangles") = py::none(),
           "part_of(triangles=None) -> numpy.ndarray\n\nThe innermost part of each triangle, -1 "
           "for none, int64 in the shape of triangles; (m,) of all\nwithout them.");
  mesh.def("part_path", &path_of_part, py::arg("part"),
           "part_path(part) -> list[str]\n\nThe names of the parts around a part, the outermost "
           "first, and its own; unnamed ones are empty.");
  def_notebook_page(mesh);
  mesh.def(
      "hash", [](const Mesh& m) { return corner_hash(m); },
      "hash() -> int\n\nFNV-1a 64 over all corners: equal for equal triangles on every "
      "machine.");
  mesh.def(
      "transformed",
      [](const Mesh& m, double scale, const py::object& up) {
        return std::make_shared<Mesh>(transformed(m, scale, enum_of<UpAxis>(up, "up")));
      },
      py::arg("scale") = 1.0, py::arg("up") = "unknown",
      "transformed(scale=1.0, up='unknown') -> Mesh\n\nScaled, and rotated to z up from an axis.");
  mesh.def(
      "closedness",
      [](const Mesh& m, bool connected, bool parts, const py::object& progress) {
        const ClosednessOptions options{.connected = connected, .parts = parts};
        return run(Work::many, 1, progress,
                   [&](const Limits& limits) { return closedness(m, options, limits); });
      },
      py::kw_only(), py::arg("connected") = false, py::arg("parts") = false,
      py::arg("progress") = py::none(),
      "closedness(*, connected=False, parts=False, progress=None) -> Closedness\n\nIs the surface "
      "closed, so that every point off it is inside or outside? Decided exactly; on\nrequest for "
      "each connected part and for each part of the file, too. O(n).");
  mesh.def(
      "defects",
      [](const Mesh& m, const py::object& progress) {
        return run(Work::many, 1, progress,
                   [&](const Limits& limits) { return find_defects(m, {}, limits); });
      },
      py::kw_only(), py::arg("progress") = py::none(),
      "defects(*, progress=None) -> Defects\n\nCounts of what is wrong or noteworthy. O(n).");
}

void bind_closedness(py::module_& module) {
  AnswerClass<PartClosedness> part(module, "PartClosedness",
                                   "Whether some triangles are a closed surface.");
  part.field("closed", &PartClosedness::closed, "Decided exactly. True without triangles.")
      .field("first", &PartClosedness::first, "The first triangle.")
      .field("triangles", &PartClosedness::triangles, "How many there are.")
      .field("degenerate", &PartClosedness::degenerate, "Of these, how many have no area.")
      .field("odd_edges", &PartClosedness::odd_edges, "Edges of an odd number of triangles.");
  AnswerClass<Closedness> whole(module, "Closedness", "Closedness of a mesh and of its parts.");
  whole.field("whole", &Closedness::whole, "Of all triangles together.")
      .derived(
          "connected", [](const Closedness& c) { return c.connected; },
          "Of each connected part, by first triangle; empty unless requested.")
      .derived(
          "parts", [](const Closedness& c) { return c.parts; },
          "Of each of Mesh.parts; empty unless requested.");
}

void bind_defects(py::module_& module) {
  AnswerClass<Defects> defects(module, "Defects",
                               "Counts of a mesh's defects; vertices are joined by position.");
  defects.field("degenerate", &Defects::degenerate, "Triangles with exactly collinear corners.")
      .field("repeated_corner", &Defects::repeated_corner, "Of these, with a corner twice.")
      .field("duplicate", &Defects::duplicate, "Triangles with the corners of an earlier one.")
      .field("doubled", &Defects::doubled, "Of these, those that face the other side.")
      .field("open_edges", &Defects::open_edges, "Edges of one triangle.")
      .field("non_manifold_edges", &Defects::non_manifold_edges, "Edges of more than two.")
      .field("flipped_edges", &Defects::flipped_edges, "Edges that two use in one direction.")
      .field("unused_vertices", &Defects::unused_vertices, "Vertices of no triangle.")
      .field("repeated_vertices", &Defects::repeated_vertices, "Vertices in one place.")
      .derived("closed", &Defects::closed, "Closed and consistently oriented.");
}

}  // namespace

void bind_meshes(py::module_& module) {
  bind_parts(module);
  bind_closedness(module);
  bind_defects(module);
  MeshClass mesh(module, "Mesh", kMeshDoc);
  mesh.def(py::init(&make_mesh), py::arg("vertices"), py::arg("triangles"),
           py::arg("parts") = std::vector<Part>(), py::kw_only(), py::arg("unit") = 0.0,
           py::arg("up") = "unknown", py::arg("source") = "", py::arg("notes") = py::tuple(),
           py::arg("file_faces") = std::vector<std::uint32_t>(),
           py::arg("georeference") = Georeference());
  bind_columns(mesh);
  bind_facts(mesh);
  mesh.def(py::pickle(
      [](const py::object& self) {
        const Mesh& m = self.cast<const Mesh&>();
        return py::make_tuple(self.attr("vertices"), self.attr("triangles"), m.parts, m.unit,
                              self.attr("up").attr("name"), Text{m.source}, texts_of(m.notes),
                              m.faces, m.georeference);
      },
      [](const py::tuple& s) {
        return make_mesh(s[0], s[1], s[2].cast<std::vector<Part>>(), s[3].cast<double>(), s[4],
                         s[5].cast<Text>(), s[6].cast<std::vector<Text>>(),
                         s[7].cast<std::vector<std::uint32_t>>(), s[8].cast<Georeference>());
      }));
}

}  // namespace soms::python
