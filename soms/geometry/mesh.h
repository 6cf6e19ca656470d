/// \file
/// Triangle meshes as they were read: nothing welded, moved or dropped.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/geometry/georeference.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace soms {

/// Number of a triangle in its mesh; fewer than 2^31.
using TriangleId = std::uint32_t;

/// Most triangles, and most vertices, that a mesh may have.
inline constexpr std::uint64_t kMaxPrimitives = (std::uint64_t{1} << 31) - 1;

/// What a file states about a part, as text.
struct Attribute {
  std::string name;
  std::string value;

  [[nodiscard]] bool operator==(const Attribute&) const = default;
};

/// A contiguous run of triangles: an object or group of the file. An object whose triangles do not
/// follow each other is several runs: the later ones name the first by `continues`.
struct Part {
  static constexpr std::uint32_t kNoParent = 0xffffffffU;

  std::string name;
  std::uint32_t parent = kNoParent;  ///< index of the enclosing part, or kNoParent
  std::uint32_t first = 0;           ///< first triangle
  std::uint32_t count = 0;           ///< number of triangles
  std::string id = {};    ///< by which the file's makers know the object, unique in the file: a
                          ///< GUID, the key of a CityJSON object; may be empty
  std::string type = {};  ///< what kind of object it is: "Building"; may be empty
  std::vector<Attribute> attributes = {};  ///< in the order of the file
  std::uint32_t continues = kNoParent;     ///< the first run of the same object, or kNoParent

  [[nodiscard]] bool operator==(const Part&) const = default;
};

/// Up axis that a file states.
enum class UpAxis { unknown, x, y, z };

template <>
inline constexpr auto kWords<UpAxis> = words("UpAxis", "The up axis that a file states.", "unknown",
                                             "x", "y", "z");

/// A triangle mesh. Triangle `i` is triangle `i` of the input; polygons of n corners gave n-2.
struct Mesh {
  std::vector<Vec3> vertices;                           ///< n points, as read
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< m x 3 indices into `vertices`
  std::vector<Part> parts;                              ///< may be empty: one unnamed part
  std::vector<std::uint32_t> faces;  ///< face of the file for each triangle; empty means identity
  double unit = 0;                   ///< meters a unit when the file says so, else 0
  UpAxis up = UpAxis::unknown;
  Georeference georeference = {};  ///< where on the Earth the numbers lie, if the file says so
  std::string source;              ///< path of the file, or what generated it
  std::vector<std::string> notes;  ///< what the file holds that was not read or applied

  [[nodiscard]] bool operator==(const Mesh&) const = default;

  /// Corners of triangle `i`, unmoved.
  [[nodiscard]] Triangle triangle(TriangleId i) const {
    const auto& t = triangles[i];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
};

/// A mesh whose arrays belong to something else, which must outlive the view: a `Mesh`, a `Shape`,
/// or a mapped tree file. Names mean what they mean in `Mesh`. What only reads a mesh takes a view,
/// and a `Mesh` converts to one.
struct MeshView {
  std::span<const Vec3> vertices;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  const std::vector<Part>& parts;
  std::span<const std::uint32_t> faces;
  double unit = 0;
  UpAxis up = UpAxis::unknown;
  const Georeference& georeference;
  const std::string& source;
  const std::vector<std::string>& notes;

  /// No triangles.
  MeshView();

  // NOLINTNEXTLINE(google-explicit-constructor): a mesh is what a view shows
  MeshView(const Mesh& mesh)
      : vertices(mesh.vertices),
        triangles(mesh.triangles),
        parts(mesh.parts),
        faces(mesh.faces),
        unit(mesh.unit),
        up(mesh.up),
        georeference(mesh.georeference),
        source(mesh.source),
        notes(mesh.notes) {}

  /// A mesh's other fields beside vertices, triangles and faces that lie elsewhere.
  MeshView(const Mesh& others, std::span<const Vec3> vertices_,
           std::span<const std::array<std::uint32_t, 3>> triangles_,
           std::span<const std::uint32_t> faces_)
      : MeshView(others) {
    vertices = vertices_;
    triangles = triangles_;
    faces = faces_;
  }

  MeshView(const MeshView&) = default;

  MeshView& operator=(const MeshView& other) {
    if (this != &other) {
      std::construct_at(this, other);  // as members are references
    }
    return *this;
  }

  /// Equal arrays and equal statements. \cost Constant for views of the same arrays, else linear.
  [[nodiscard]] bool operator==(const MeshView& other) const;

  /// A copy of all that the view shows. \cost Linear.
  [[nodiscard]] explicit operator Mesh() const;

  /// Corners of triangle `i`, unmoved.
  [[nodiscard]] Triangle triangle(TriangleId i) const {
    const auto& t = triangles[i];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
};

/// Throws unless the mesh is fit for trees and queries: indices in range, counts below 2^31, every
/// corner of every triangle finite and of magnitude at most 2^300, parts and faces consistent.
/// \errors ErrorKind::not_finite, out_of_range, bad_file; names the first such triangle.
void check(const MeshView& mesh);

/// Bounds of the corners of all triangles (unused vertices do not count).
[[nodiscard]] Box bounds(const MeshView& mesh);

/// Part that triangle `i` belongs to: the innermost by position, or Part::kNoParent without parts.
/// For an object of several runs it is the first, whichever run holds the triangle.
[[nodiscard]] std::uint32_t part_of(const MeshView& mesh, TriangleId i);

/// The first run of the object that `part` is a run of: itself, if it continues none.
/// Part::kNoParent gives Part::kNoParent.
[[nodiscard]] inline std::uint32_t first_run(const MeshView& mesh, std::uint32_t part) {
  return part == Part::kNoParent || mesh.parts[part].continues == Part::kNoParent
             ? part
             : mesh.parts[part].continues;
}

/// Appends `other`, keeping its parts and faces; a mesh without parts becomes one part named by its
/// source. Triangle i of `other` becomes triangle `mesh.triangles.size() + i`. Unit, up axis and
/// georeference stay those of `mesh`.
/// \errors ErrorKind::out_of_range when the sum exceeds `kMaxPrimitives`.
void append(Mesh& mesh, const MeshView& other);

/// FNV-1a 64 over all corner coordinates, triangle by triangle, as little-endian doubles.
[[nodiscard]] std::uint64_t corner_hash(const MeshView& mesh);

/// A mesh with every vertex multiplied by `scale`, and turned from `up` to z up as COLLADA does it.
/// With y up, (x, y, z) becomes (x, -z, y); with x up, it becomes (-y, -z, x); `unknown` and `z` do
/// not turn. Turning permutes and negates, without rounding; the result states z up after x, y, z.
/// A georeference is `scaled` with the vertices, and is gone from a mesh that was turned.
/// \errors ErrorKind::usage unless `scale` is finite and positive.
[[nodiscard]] Mesh transformed(Mesh mesh, double scale, UpAxis up);

}  // namespace soms
