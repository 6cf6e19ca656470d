// Models and poses in files.
#include "soms/io/poses.h"
#include "soms/io/read_mesh.h"
#include "soms/io/write_mesh.h"

#include "python/src/arrays.h"
#include "python/src/call.h"
#include "python/src/enums.h"
#include "python/src/paths.h"
#include "python/src/scene/bodies.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kReadDoc =
    R"(read_mesh(file, *, name='', strict=False, allow_empty=False, max_memory=0, lod=None, surfaces=False, progress=None)

Reads a PLY, 3DS, STL, OFF, OBJ, glTF, GLB, CityJSON, 3D Tiles or COLLADA model as stored, in
double.

file: a path, or bytes; name stands for bytes in messages, and its extension tells the format where
the content does not. strict: what would be noted in Mesh.notes is an error. allow_empty: accept a
model without triangles. max_memory: most bytes; 0 for 64 times the file's size and 64 MiB. lod: the
level of detail of a city in CityJSON, 1.2 for example; None: the most detailed of each object.
surfaces: make each semantic surface of a city in CityJSON a part in the part of its object.

Raises Error of kind cannot_open, bad_file (names line or byte), empty_mesh, not_finite,
out_of_range, unsupported, out_of_memory, usage (lod or surfaces for what is no city).)";

constexpr const char* kWriteDoc = R"(write_mesh(path, mesh, format=None)

Writes a model; the file appears whole or not at all.

format: a name of MeshFormat; by default that of the path's extension: .ply, .3ds, .stl, .off, .obj
or .glb. PLY, OFF and OBJ keep every bit; the others hold floats of 4 bytes.

Raises Error of kind cannot_write, unsupported, out_of_range.)";

constexpr const char* kReadPosesDoc = R"(read_poses(path) -> numpy.ndarray

Poses of a CSV file with a header, or of a NumPy array file: (n, 3, 4) float64.

Raises Error of kind cannot_open, bad_file, not_finite, not_rigid; names file and line, or row.)";

std::shared_ptr<Mesh> read(const py::object& file, const std::string& name, bool strict,
                           bool allow_empty, std::uint64_t max_memory, std::optional<double> lod,
                           bool surfaces, const py::object& progress) {
  const ReadOptions options{.allow_empty = allow_empty,
                            .max_memory = max_memory,
                            .strict = strict,
                            .lod = lod,
                            .surfaces = surfaces};
  if (PyObject_CheckBuffer(file.ptr()) != 0) {
    const std::vector<std::byte> bytes = bytes_of(file);
    return run(Work::many, 1, progress, [&](const Limits& limits) {
      return std::make_shared<Mesh>(
          read_mesh(bytes, name.empty() ? "bytes" : name, options, limits));
    });
  }
  const std::filesystem::path path = path_of(file);
  return run(Work::many, 1, progress, [&](const Limits& limits) {
    return std::make_shared<Mesh>(read_mesh(path, options, limits));
  });
}

void write(const py::object& place, const py::object& given, const py::object& format) {
  const std::filesystem::path path = path_of(place);
  const auto mesh = mesh_of(given, "mesh");
  const MeshFormat chosen =
      format.is_none() ? format_for(path) : enum_of<MeshFormat>(format, "format");
  run(Work::many, 1, py::none(), [&](const Limits& limits) {
    write_mesh(path, *mesh, chosen, limits);
    return true;
  });
}

py::array read_all_poses(const py::object& file) {
  const std::filesystem::path path = path_of(file);
  auto* const poses = new std::vector<Pose>(run(
      Work::many, 1, py::none(), [&](const Limits& limits) { return read_poses(path, limits); }));
  const py::capsule owner(poses, [](void* held) { delete static_cast<std::vector<Pose>*>(held); });
  constexpr py::ssize_t kNumber = sizeof(double);
  return {py::dtype::of<double>(),
          {static_cast<py::ssize_t>(poses->size()), py::ssize_t{3}, py::ssize_t{4}},
          {12 * kNumber, 4 * kNumber, kNumber},
          poses->data(),
          owner};
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("read_mesh", &read, py::arg("file"), py::kw_only(), py::arg("name") = "",
             py::arg("strict") = false, py::arg("allow_empty") = false, py::arg("max_memory") = 0,
             py::arg("lod") = py::none(), py::arg("surfaces") = false,
             py::arg("progress") = py::none(), kReadDoc);
  module.def("write_mesh", &write, py::arg("path"), py::arg("mesh"), py::arg("format") = py::none(),
             kWriteDoc);
  module.def("read_poses", &read_all_poses, py::arg("path"), kReadPosesDoc);
}

}  // namespace soms::python
