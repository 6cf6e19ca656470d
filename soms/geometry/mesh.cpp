#include "soms/geometry/mesh.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/base/pose.h"
#include "soms/geometry/detail/counts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soms {

namespace {

std::string place(const MeshView& mesh, const std::string& what) {
  return (mesh.source.empty() ? std::string("mesh") : mesh.source) + ", " + what;
}

void check_tables(const MeshView& mesh) {
  if (!mesh.faces.empty() && mesh.faces.size() != mesh.triangles.size()) {
    throw Error(ErrorKind::bad_file,
                place(mesh, "the face map does not have one entry per triangle"),
                "leave it empty, or give one entry per triangle");
  }
  for (const Part& part : mesh.parts) {
    if (std::uint64_t{part.first} + part.count > mesh.triangles.size() ||
        (part.parent != Part::kNoParent && part.parent >= mesh.parts.size())) {
      throw Error(ErrorKind::bad_file, place(mesh, "part \"" + part.name + "\" is out of range"),
                  "give first and count within the triangles, and a parent that exists");
    }
    if (part.continues != Part::kNoParent &&
        (part.continues >= mesh.parts.size() ||
         mesh.parts[part.continues].continues != Part::kNoParent)) {
      throw Error(ErrorKind::bad_file,
                  place(mesh, "part \"" + part.name + "\" continues what is no first run"),
                  "name the first run of the object, which continues none itself");
    }
  }
}

void check_corner(const MeshView& mesh, std::size_t triangle, const Vec3& v) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(v[axis])) {
      throw Error(ErrorKind::not_finite,
                  place(mesh, "triangle " + std::to_string(triangle) + ": " + "xyz"[axis] +
                                  " of a corner is not a finite number"),
                  "repair or drop the triangle");
    }
    if (std::abs(v[axis]) > kMaxCoordinate) {
      throw Error(ErrorKind::out_of_range,
                  place(mesh, "triangle " + std::to_string(triangle) + ": " + "xyz"[axis] +
                                  " of a corner exceeds 2^300"),
                  "scale the mesh");
    }
  }
}

/// True if every index is in range and every vertex, used or not, may be a corner: two passes in
/// order, while corners lie anywhere.
bool surely_fit(const MeshView& mesh) {
  std::uint32_t most = 0;
  for (const auto& t : mesh.triangles) {
    most = std::max({most, t[0], t[1], t[2]});
  }
  if (!mesh.triangles.empty() && most >= mesh.vertices.size()) {
    return false;
  }
  int bad = 0;
  for (const Vec3& v : mesh.vertices) {
    // False for what is not a number, too.
    bad |= std::abs(v.x) <= kMaxCoordinate ? 0 : 1;
    bad |= std::abs(v.y) <= kMaxCoordinate ? 0 : 1;
    bad |= std::abs(v.z) <= kMaxCoordinate ? 0 : 1;
  }
  return bad == 0;
}

template <class T>
bool equal(std::span<const T> a, std::span<const T> b) {
  return (a.data() == b.data() && a.size() == b.size()) ||
         std::equal(a.begin(), a.end(), b.begin(), b.end());
}

const Mesh kNoMesh;

}  // namespace

MeshView::MeshView() : MeshView(kNoMesh) {
}

MeshView::operator Mesh() const {
  return {.vertices = {vertices.begin(), vertices.end()},
          .triangles = {triangles.begin(), triangles.end()},
          .parts = parts,
          .faces = {faces.begin(), faces.end()},
          .unit = unit,
          .up = up,
          .georeference = georeference,
          .source = source,
          .notes = notes};
}

bool MeshView::operator==(const MeshView& other) const {
  return equal(vertices, other.vertices) && equal(triangles, other.triangles) &&
         parts == other.parts && equal(faces, other.faces) && unit == other.unit &&
         up == other.up && georeference == other.georeference && source == other.source &&
         notes == other.notes;
}

void check(const MeshView& mesh) {
  const PlainArithmetic plain;
  check_counts(mesh.vertices.size(), mesh.triangles.size(),
               mesh.source.empty() ? "mesh" : mesh.source);
  check_tables(mesh);
  if (surely_fit(mesh)) {
    return;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t v : mesh.triangles[i]) {
      if (v >= mesh.vertices.size()) {
        throw Error(ErrorKind::bad_file,
                    place(mesh, "triangle " + std::to_string(i) + ": " +
                                    index_fault("vertex " + std::to_string(v), "vertices",
                                                mesh.vertices.size())),
                    "repair or drop the triangle");
      }
      check_corner(mesh, i, mesh.vertices[v]);
    }
  }
}

Box bounds(const MeshView& mesh) {
  const PlainArithmetic plain;
  Box box;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      box.grow(mesh.vertices[v]);
    }
  }
  return box;
}

std::uint32_t part_of(const MeshView& mesh, TriangleId i) {
  std::uint32_t best = Part::kNoParent;
  for (std::uint32_t p = 0; p < mesh.parts.size(); ++p) {
    const Part& part = mesh.parts[p];
    if (i >= part.first && i - part.first < part.count &&
        (best == Part::kNoParent || part.count <= mesh.parts[best].count)) {
      best = p;
    }
  }
  return first_run(mesh, best);
}

void append(Mesh& mesh, const MeshView& other) {
  if (other.vertices.data() == mesh.vertices.data() && !mesh.vertices.empty()) {
    append(mesh, Mesh(other));
    return;
  }
  const std::size_t vertices = mesh.vertices.size();
  const std::size_t triangles = mesh.triangles.size();
  if (vertices + other.vertices.size() > kMaxPrimitives ||
      triangles + other.triangles.size() > kMaxPrimitives) {
    throw Error(ErrorKind::out_of_range, place(other, "too many triangles when joined"),
                "join fewer models: at most 2^31 - 1 triangles and vertices together");
  }
  const auto whole = [](const MeshView& m) {
    return Part{m.source, Part::kNoParent, 0, static_cast<std::uint32_t>(m.triangles.size())};
  };
  if (mesh.parts.empty() && triangles > 0) {
    mesh.parts.push_back(whole(mesh));
  }
  const auto first_part = static_cast<std::uint32_t>(mesh.parts.size());
  std::vector<Part> parts = other.parts;
  if (parts.empty()) {
    parts.push_back(whole(other));
  }
  for (Part& part : parts) {
    part.first += static_cast<std::uint32_t>(triangles);
    if (part.parent != Part::kNoParent) {
      part.parent += first_part;
    }
    if (part.continues != Part::kNoParent) {
      part.continues += first_part;
    }
    mesh.parts.push_back(std::move(part));
  }
  if (!mesh.faces.empty() || !other.faces.empty()) {
    for (std::size_t i = mesh.faces.size(); i < triangles; ++i) {
      mesh.faces.push_back(static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < other.triangles.size(); ++i) {
      mesh.faces.push_back(other.faces.empty() ? static_cast<std::uint32_t>(i) : other.faces[i]);
    }
  }
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (auto t : other.triangles) {
    for (auto& v : t) {
      v += static_cast<std::uint32_t>(vertices);
    }
    mesh.triangles.push_back(t);
  }
}

std::uint64_t corner_hash(const MeshView& mesh) {
  Fnv1a hash;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      const Vec3& p = mesh.vertices[v];
      hash.add(p.x);
      hash.add(p.y);
      hash.add(p.z);
    }
  }
  return hash.value();
}

Mesh transformed(Mesh mesh, double scale, UpAxis up) {
  const PlainArithmetic plain;
  if (!(std::isfinite(scale) && scale > 0)) {
    throw Error(ErrorKind::usage, "scale " + std::to_string(scale) + " is not a positive number",
                "give a finite scale above 0");
  }
  for (Vec3& v : mesh.vertices) {
    if (up == UpAxis::y) {
      v = {v.x, -v.z, v.y};
    } else if (up == UpAxis::x) {
      v = {-v.y, -v.z, v.x};
    }
    if (scale != 1) {
      v = v * scale;
    }
  }
  if (up != UpAxis::unknown) {
    mesh.up = UpAxis::z;
  }
  if (mesh.unit > 0 && scale != 1) {
    mesh.unit /= scale;
    if (!(mesh.unit > 0 && std::isfinite(mesh.unit))) {
      mesh.unit = 0;  // unknown: no double holds it
    }
  }
  mesh.georeference = up == UpAxis::x || up == UpAxis::y
                          ? Georeference{}
                          : scaled(std::move(mesh.georeference), scale);
  return mesh;
}

}  // namespace soms
