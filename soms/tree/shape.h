/// \file
/// A mesh ready for queries: shared, immutable, cheap to copy.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/words.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/build_options.h"
#include "soms/tree/tree.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace soms {

class WideTree;
class Shape;

namespace detail {
struct ShapeParts;
Shape opened(ShapeParts parts);
std::pair<double, double> areas_of(const Shape& shape);
}  // namespace detail

/// A tree file that a shape was opened from (`soms/store/tree_file.h`).
struct TreeFileName {
  std::string path;        ///< as it was given, or the name of the bytes
  std::uint64_t hash = 0;  ///< of its content

  [[nodiscard]] bool operator==(const TreeFileName&) const = default;
};

/// How the tree that queries traverse is kept.
enum class Layout {
  wide,     ///< for speed: boxes and corners in float, 70 to 80 bytes a triangle
  compact,  ///< for memory: boxes in bytes, corners read from the mesh; about 12 bytes a triangle
};

template <>
inline constexpr auto kWords<Layout> = words("Layout",
                                             "How a tree is kept: for speed, or for memory.",
                                             "wide", "compact");

/// What a shape keeps beside its mesh.
struct ShapeOptions {
  BuildOptions build = {};
  /// Keep the canonical tree, which the named traversals and the statistics need.
  bool keep_tree = false;
  /// Answers are the same with each.
  Layout layout = Layout::wide;

  [[nodiscard]] bool operator==(const ShapeOptions&) const = default;
};

/// A mesh and the layout that queries run on. Copies share both. A default shape is empty.
class Shape {
 public:
  Shape();

  /// Checks the mesh, builds its tree and converts it.
  /// \errors  As `check(Mesh)` and `build`.
  explicit Shape(Mesh mesh, const ShapeOptions& options = {}, const Limits& limits = {});
  explicit Shape(std::shared_ptr<const Mesh> mesh, const ShapeOptions& options = {},
                 const Limits& limits = {});

  /// The mesh, for as long as this shape or a copy of it lives.
  [[nodiscard]] const MeshView& mesh() const { return *mesh_; }

  /// The mesh that the shape was built on. A shape that was opened from a tree file copies its mesh
  /// at the first call, once for all of its copies.
  [[nodiscard]] std::shared_ptr<const Mesh> shared_mesh() const;

  /// The tree file that the shape was opened from, or nullptr where it was built.
  [[nodiscard]] const TreeFileName* tree_file() const;

  /// Bounds of the mesh, unmoved; empty for an empty mesh.
  [[nodiscard]] const Box& bounds() const { return bounds_; }

  /// The canonical tree, or nullptr unless it was kept.
  [[nodiscard]] const Tree* tree() const { return tree_.get(); }

  /// What queries traverse; its class is private to the library.
  [[nodiscard]] const WideTree& layout() const { return *layout_; }

  /// How the layout is kept.
  [[nodiscard]] Layout layout_kind() const;

  [[nodiscard]] const BuildOptions& build_options() const { return build_options_; }

  /// How far the tree has fallen behind: 1 as built; after `refit` the area of its boxes for each
  /// unit of the triangles' area, over what it was as built. See `build_is_due`.
  [[nodiscard]] double sah_degradation() const { return sah_degradation_; }

  /// Bytes held: mesh, layout, and tree where kept.
  [[nodiscard]] std::size_t memory() const;

  /// Bytes of the layout alone.
  [[nodiscard]] std::size_t layout_memory() const;

  /// Equal meshes with equal layouts, equal trees where they were kept, equal options and
  /// `sah_degradation`: every query has the same answer and the same cost. \cost Constant for
  /// copies of one shape, else linear.
  [[nodiscard]] bool operator==(const Shape& other) const;

 private:
  friend Shape refit(const Shape& shape, std::shared_ptr<const Mesh> mesh, const Limits& limits);
  friend Shape detail::opened(detail::ShapeParts parts);
  friend std::pair<double, double> detail::areas_of(const Shape& shape);

  std::shared_ptr<const MeshView> mesh_;  ///< a detail::HeldMesh
  std::shared_ptr<const Tree> tree_;
  std::shared_ptr<const WideTree> layout_;
  Box bounds_;
  BuildOptions build_options_;
  double sah_area_ratio_ = 0;  ///< of the layout as built; 0 before the first refit
  double sah_degradation_ = 1;
};

}  // namespace soms
