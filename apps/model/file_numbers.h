/// \file
/// The numbers that triangles have in their file, where parts of a model are left out.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/overlap.h"
#include "soms/tree/shape.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace soms::command {

/// From numbers of a shape's triangles, or of its vertices, to those of its file.
class FileNumbers {
 public:
  /// The same numbers.
  FileNumbers() = default;

  /// `numbers` of each triangle, ascending.
  explicit FileNumbers(std::vector<TriangleId> numbers)
      : numbers_(std::make_shared<const std::vector<TriangleId>>(std::move(numbers))) {}

  [[nodiscard]] bool are_the_same() const { return !numbers_; }

  [[nodiscard]] TriangleId operator()(TriangleId triangle) const {
    return numbers_ ? (*numbers_)[triangle] : triangle;
  }

  /// Of each triangle; empty where they are the same.
  [[nodiscard]] std::span<const TriangleId> list() const {
    return numbers_ ? std::span(*numbers_) : std::span<const TriangleId>();
  }

  /// The triangle of the shape that has this number in the file; nothing where it is left out.
  [[nodiscard]] std::optional<TriangleId> in_shape(TriangleId number) const;

 private:
  std::shared_ptr<const std::vector<TriangleId>> numbers_;
};

/// A model of which parts may be left out.
struct ModelShape {
  Shape shape;                                 ///< of what is left
  std::shared_ptr<const Mesh> file = nullptr;  ///< the whole model; none: nothing is left out
  FileNumbers numbers = {};                    ///< from triangles of `shape` to those of `file`

  /// The mesh whose triangles have the numbers of the file.
  [[nodiscard]] MeshView file_mesh() const { return file ? MeshView(*file) : shape.mesh(); }
};

/// An answer about two shapes with the numbers of their files.
[[nodiscard]] TrianglePair in_files(const FileNumbers& a, const FileNumbers& b,
                                    const TrianglePair& pair);
[[nodiscard]] Overlap in_files(const FileNumbers& a, const FileNumbers& b, Overlap answer);

}  // namespace soms::command
