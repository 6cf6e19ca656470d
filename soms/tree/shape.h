/// \file
/// A mesh ready for queries: shared, immutable, cheap to copy.
#pragma once

#include "soms/base/parallel.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/build_options.h"
#include "soms/tree/tree.h"

#include <memory>

namespace soms {

class WideTree;

/// How the tree that queries traverse is kept.
enum class Layout {
  wide,     ///< for speed: boxes and corners in float, 70 to 80 bytes a triangle
  compact,  ///< for memory: boxes in bytes, corners read from the mesh; about 12 bytes a triangle
};

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
  explicit Shape(Mesh mesh, const ShapeOptions& options = {}, const Parallel& parallel = {});
  explicit Shape(std::shared_ptr<const Mesh> mesh, const ShapeOptions& options = {},
                 const Parallel& parallel = {});

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }

  [[nodiscard]] const std::shared_ptr<const Mesh>& shared_mesh() const { return mesh_; }

  /// Bounds of the mesh, unmoved; empty for an empty mesh.
  [[nodiscard]] const Box& bounds() const { return bounds_; }

  /// The canonical tree, or nullptr unless it was kept.
  [[nodiscard]] const Tree* tree() const { return tree_.get(); }

  [[nodiscard]] const WideTree& layout() const { return *layout_; }

  [[nodiscard]] const BuildOptions& build_options() const { return build_options_; }

  /// How far the tree has fallen behind: 1 as built; after `refit` the area of its boxes for each
  /// unit of the triangles' area, over what it was as built. See `build_is_due`.
  [[nodiscard]] double sah_degradation() const { return sah_degradation_; }

  /// Bytes held: mesh, layout, and tree where kept.
  [[nodiscard]] std::size_t memory() const;

  /// Equal meshes with equal layouts, equal trees where they were kept, equal options and
  /// `sah_degradation`: every query has the same answer and the same cost. \cost Constant for
  /// copies of one shape, else linear.
  [[nodiscard]] bool operator==(const Shape& other) const;

 private:
  friend Shape refit(const Shape& shape, std::shared_ptr<const Mesh> mesh,
                     const Parallel& parallel);

  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const Tree> tree_;
  std::shared_ptr<const WideTree> layout_;
  Box bounds_;
  BuildOptions build_options_;
  double sah_area_ratio_ = 0;  ///< of the layout as built; 0 before the first refit
  double sah_degradation_ = 1;
};

}  // namespace soms
