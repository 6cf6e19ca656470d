/// \file
/// PLY: ascii, little and big endian; any elements and properties.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/mesh_builder.h"
#include "soms/io/detail/ply/ply_header.h"
#include "soms/io/detail/source.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::detail {

/// \errors ErrorKind::bad_file, not_finite, out_of_range, empty_mesh, out_of_memory, cancelled.
[[nodiscard]] Mesh read_ply(Source& source);

/// Numbers of the properties that make a vertex or a face.
using VertexColumns = std::array<std::size_t, 3>;

/// The body of a PLY file: its elements one after another. All calls move on by one element.
class PlyBody {
 public:
  PlyBody(Source& source, MeshBuilder& builder) : source_(source), builder_(builder) {}

  virtual ~PlyBody() = default;
  PlyBody(const PlyBody&) = delete;
  PlyBody& operator=(const PlyBody&) = delete;

  /// First byte of the next element.
  [[nodiscard]] virtual std::size_t position() const = 0;
  virtual void go_to(std::size_t position) = 0;

  virtual void skip(const PlyElement& element) = 0;
  virtual void read_vertices(const PlyElement& element, const VertexColumns& columns) = 0;
  /// A face for each row: the list in `column`.
  virtual void read_faces(const PlyElement& element, std::size_t column) = 0;
  /// Triangle strips, parted by -1, in the list in `column`.
  void read_strips(const PlyElement& element, std::size_t column);
  /// Behind the last element: refuses or notes what the header does not declare.
  virtual void finish() = 0;

 protected:
  /// Before an element's first row: fails unless its rows, at their least, fit into what is left.
  virtual void begin_element(const PlyElement& element) = 0;
  /// Reads a row; `corners_` becomes its list in `column`: vertex numbers, each at least `least`.
  virtual void read_row(const PlyElement& element, std::size_t column, std::int64_t least) = 0;

  Source& source_;
  MeshBuilder& builder_;
  std::vector<std::int64_t> corners_;
};

/// A row of triangle strips, corner by corner; -1 ends a strip.
class PlyStrip {
 public:
  explicit PlyStrip(MeshBuilder& builder) : builder_(builder) {}

  /// `corner` is -1 or a vertex that exists.
  void add(std::int64_t corner) {
    if (corner < 0) {
      end();
      return;
    }
    const auto v = static_cast<std::uint32_t>(corner);
    if (length_ >= 2) {
      // Every second triangle of a strip turns the other way; swapping two corners turns it back.
      if (length_ % 2 == 0) {
        builder_.add_triangle(first_, second_, v);
      } else {
        builder_.add_triangle(second_, first_, v);
      }
    }
    first_ = second_;
    second_ = v;
    ++length_;
  }

  /// Ends the last strip.
  void end() {
    thin_ += length_ == 1 || length_ == 2 ? 1U : 0U;
    length_ = 0;
  }

  /// Strips of one or two corners, which give no triangle.
  [[nodiscard]] std::uint64_t thin() const { return thin_; }

 private:
  MeshBuilder& builder_;
  std::uint64_t thin_ = 0;
  std::uint64_t length_ = 0;
  std::uint32_t first_ = 0;
  std::uint32_t second_ = 0;
};

}  // namespace soms::detail
