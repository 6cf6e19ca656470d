/// \file
/// A mesh that grows while a file is read, within the reader's memory.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/geometry/polygon.h"
#include "soms/geometry/polygon_holes.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/source.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Note of faces that give no triangle.
inline constexpr std::string_view kThinFaces = "faces with fewer than three corners, not read";

/// Collects vertices, faces and parts. Indices are checked by the reader, which knows the place.
class MeshBuilder {
 public:
  explicit MeshBuilder(Source& source) : source_(source) {}

  /// Room for exactly so many more; the counts have been checked against the file's size.
  void reserve_vertices(std::uint64_t count) { reserve(mesh_.vertices, count); }

  void reserve_triangles(std::uint64_t count) { reserve(mesh_.triangles, count); }

  void add_vertex(const Vec3& v) { push(mesh_.vertices, v); }

  /// A face of three corners.
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    push(mesh_.triangles, {a, b, c});
    if (mapped_) [[unlikely]] {
      push(mesh_.faces, face_);
    }
    ++face_;
  }

  /// A face of any number of corners: n-2 triangles; fewer than three corners give none, which is
  /// noted in the mesh.
  /// \errors ErrorKind::out_of_memory, out_of_range.
  void add_face(std::span<const std::uint32_t> corners);

  /// A face with holes: the corners of its outline, then those of each hole, with `ends` behind the
  /// last of each. Holes that lie outside of it or cross it are left out, which is noted.
  /// \errors As `add_face`.
  void add_face(std::span<const std::uint32_t> corners, std::span<const std::size_t> ends);

  /// The triangles of `mesh` once more, on vertices from `first` on and in faces of their own, as
  /// many as `faces`; `turned` ones go around the other way.
  /// \errors ErrorKind::out_of_memory, out_of_range.
  void add_instance(const MeshView& mesh, std::uint32_t first, std::uint32_t faces, bool turned);

  /// Begins a part that holds all triangles from here to the next one. Parts without triangles
  /// vanish.
  void begin_part(std::string_view name);

  /// As `begin_part`, for a format of objects that hold groups: an object, with groups of its own.
  void begin_object(std::string_view name);

  /// Begins a group of the object that was begun last, or of the file before the first object. A
  /// group whose name that object has had goes on: one part, in several runs if need be. Without a
  /// name the triangles that follow are of no group: the object's own.
  /// \errors ErrorKind::out_of_memory.
  void begin_group(std::string_view name);

  /// Opens a part within the one that was opened last and is not closed yet. Formats whose parts
  /// nest use this and `close_part` in place of `begin_part`.
  void open_part(std::string_view name);

  /// Adds what the file states about the part that was opened last. \errors
  /// ErrorKind::out_of_memory.
  void describe_part(std::string_view id, std::string_view type,
                     std::vector<Attribute> attributes = {});

  /// Opens one more run of the object whose first run is part `first`, as `open_part` does.
  void continue_part(std::uint32_t first);

  /// Number of the part that was opened last. \pre One is open.
  [[nodiscard]] std::uint32_t opened_part() const { return open_parts_.back(); }

  /// Closes the part that was opened last; one without triangles vanishes.
  void close_part();

  /// Adds to the mesh's notes. \errors ErrorKind::out_of_memory.
  void note(std::string text);

  /// The note of what was left out, if there is any. \errors ErrorKind::out_of_memory.
  void note(const LeftOut& left_out, std::string_view what);

  [[nodiscard]] const std::vector<Vec3>& vertices() const { return mesh_.vertices; }

  [[nodiscard]] std::size_t triangle_count() const { return mesh_.triangles.size(); }

  /// Faces so far, those that gave no triangle too.
  [[nodiscard]] std::uint32_t face_count() const { return face_; }

  /// Vectors for readers that fill them in one go after reserving.
  [[nodiscard]] std::vector<Vec3>& raw_vertices() { return mesh_.vertices; }

  /// The mesh. \errors ErrorKind::empty_mesh.
  [[nodiscard]] Mesh finish();

 private:
  template <class T>
  void reserve(std::vector<T>& items, std::uint64_t more) {
    const std::uint64_t wanted = items.size() + more;
    if (wanted > items.capacity()) {
      grow(items, wanted);
    }
  }

  template <class T>
  void push(std::vector<T>& items, const T& item) {
    if (items.size() == items.capacity()) [[unlikely]] {
      grow(items, std::max<std::uint64_t>(16, 2 * std::uint64_t{items.size()}));
    }
    items.push_back(item);
  }

  /// New memory is taken before the old is given back: the peak counts.
  template <class T>
  void grow(std::vector<T>& items, std::uint64_t capacity) {
    if (items.size() >= kMaxPrimitives) {
      source_.fail(ErrorKind::out_of_range, "more than 2^31 - 1 vertices or triangles",
                   "split the model");
    }
    capacity = std::min(capacity, kMaxPrimitives);
    take(capacity * sizeof(T));
    const std::uint64_t old = items.capacity() * sizeof(T);
    items.reserve(static_cast<std::size_t>(capacity));
    source_.budget.give_back(old);
  }

  void take(std::uint64_t bytes);
  void map_faces();
  void name_triangles_before_parts();
  void close_group();

  Source& source_;
  Mesh mesh_;
  PolygonTriangulator triangulator_;
  HoleJoiner hole_joiner_;
  std::vector<std::uint32_t> joined_;
  std::vector<Vec3> corners_;
  std::vector<std::uint32_t> open_parts_;  ///< from the outermost to the innermost
  /// First runs of the groups of the object at hand, by name. A tree, as names of a file could be
  /// chosen to collide.
  std::map<std::string, std::uint32_t, std::less<>> groups_;
  std::uint64_t group_bytes_ = 0;  ///< that `groups_` took
  bool in_object_ = false;
  std::uint32_t face_ = 0;
  LeftOut thin_faces_;
  LeftOut lost_holes_;
  bool mapped_ = false;
};

}  // namespace soms::detail
