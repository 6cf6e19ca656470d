#include "soms/io/detail/robot/urdf_geometry.h"

#include "soms/base/text.h"
#include "soms/io/detail/robot/package_paths.h"
#include "soms/io/detail/text.h"
#include "soms/io/read_mesh.h"
#include "soms/kinematics/primitive_meshes.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

namespace soms::detail {

namespace {

/// Bytes of a mesh's vertices and triangles.
std::uint64_t size_of(const MeshView& mesh) {
  return mesh.vertices.size() * sizeof(Vec3) + mesh.triangles.size() * 12 + mesh.faces.size() * 4;
}

bool is_size(double value) {
  return value >= 0 && value <= kMaxCoordinate;
}

}  // namespace

void UrdfShapes::note(const std::string& text) {
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) {
    notes_.push_back(text);
  }
}

Mesh UrdfShapes::read(pugi::xml_node collision) {
  check(document_.source().limits);
  const Pose origin = read_origin(document_, collision);
  Mesh mesh = shape_of(required_child(document_, collision, "geometry"));
  for (Vec3& vertex : mesh.vertices) {
    if (origin != Pose{}) {
      vertex = origin.apply(vertex);
    }
    if (!fit_for_mesh(vertex)) {
      const CoordinateFault fault = describe_fault(vertex);
      document_.fail(collision, fault.what, fault.remedy, fault.kind);
    }
  }
  return mesh;
}

Mesh UrdfShapes::shape_of(pugi::xml_node geometry) {
  pugi::xml_node shape;
  for (const pugi::xml_node child : geometry.children()) {
    if (child.type() != pugi::node_element) {
      continue;
    }
    if (shape) {
      document_.fail(child, "<geometry> has a second shape, " + named_element(child),
                     "give each shape a <collision> of its own");
    }
    shape = child;
  }
  if (!shape) {
    document_.fail(geometry, "<geometry> has no shape", "give it a mesh, box, cylinder or sphere");
  }
  const std::string_view name = shape.name();
  if (name == "mesh") {
    return read_file(shape);
  }
  if (name == "box" || name == "cylinder" || name == "sphere") {
    return primitive(shape);
  }
  document_.fail(shape, named_element(shape) + " is a shape that soms does not read",
                 "give it as a mesh, box, cylinder or sphere", ErrorKind::unsupported);
}

/// A box, cylinder or sphere. Its memory is taken afterwards: the most that one needs is bounded.
Mesh UrdfShapes::primitive(pugi::xml_node element) {
  const std::string_view name = element.name();
  const auto size_of_attribute = [&](const char* attribute) {
    const double value = required_number(document_, element, attribute);
    if (!is_size(value)) {
      document_.fail(element, std::string(attribute) + " of " + named_element(element) +
                                  " is not a number from 0 to 2^300");
    }
    if (value == 0) {
      flat_.add([&] { return document_.place_of(element); });
    }
    return value;
  };
  PrimitiveMesh shape;
  try {
    if (name == "box") {
      static_cast<void>(required_text(document_, element, "size"));
      const Vec3 size = vector_or(document_, element, "size", {});
      if (!is_size(size.x) || !is_size(size.y) || !is_size(size.z)) {
        document_.fail(element, "size of <box> is not three numbers from 0 to 2^300");
      }
      if (size.x == 0 || size.y == 0 || size.z == 0) {
        flat_.add([&] { return document_.place_of(element); });
      }
      shape = box_mesh(size);
    } else if (name == "cylinder") {
      const double radius = size_of_attribute("radius");
      shape = cylinder_mesh(radius, size_of_attribute("length"), options_.tessellation_error);
    } else {
      shape = sphere_mesh(size_of_attribute("radius"), options_.tessellation_error);
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::out_of_range && error.kind() != ErrorKind::usage) {
      throw;
    }
    document_.fail(element, error.place(), error.remedy(), ErrorKind::out_of_range);
  }
  document_.take(size_of(shape.mesh));
  error_ = std::max(error_, shape.error);
  shape.mesh.source = name;
  shape.mesh.source += ' ';
  shape.mesh.source += document_.place_of(element);
  return std::move(shape.mesh);
}

/// A mesh as its file has it, in meters if that states its unit.
const Mesh& UrdfShapes::stored(const std::filesystem::path& path) {
  const auto known = files_.find(path);
  if (known != files_.end()) {
    return known->second;
  }
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown)) {
    throw Error(ErrorKind::cannot_open, path.string() + " is not a regular file",
                "name a file of a mesh");
  }
  Mesh mesh = read_mesh(path, {.max_memory = options_.max_memory, .strict = options_.strict},
                        document_.source().limits);
  for (const std::string& text : mesh.notes) {
    note(mesh.source + ": " + text);
  }
  if (mesh.unit > 0 && mesh.unit != 1) {
    for (Vec3& v : mesh.vertices) {
      v = v * mesh.unit;
    }
    mesh.unit = 1;
  }
  return files_.emplace(path, std::move(mesh)).first->second;
}

Mesh UrdfShapes::read_file(pugi::xml_node element) {
  const std::string uri = required_text(document_, element, "filename");
  const Vec3 scale = vector_or(document_, element, "scale", {1, 1, 1});
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
    document_.fail(element, "scale of <mesh> has a zero", "give three numbers other than 0");
  }
  try {
    const Mesh& file =
        stored(resolved_uri(uri, document_.source().folder, options_).lexically_normal());
    document_.take(size_of(file));
    Mesh mesh = file;
    if (scale != Vec3{1, 1, 1}) {
      for (Vec3& v : mesh.vertices) {
        v = {v.x * scale.x, v.y * scale.y, v.z * scale.z};
      }
    }
    return mesh;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled ||
        error.place().starts_with(document_.source().name)) {
      throw;
    }
    document_.fail(element, "mesh " + quoted_text(uri) + ": " + error.place(), error.remedy(),
                   error.kind());
  }
}

}  // namespace soms::detail
