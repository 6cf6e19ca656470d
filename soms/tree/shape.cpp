#include "soms/tree/shape.h"

#include "soms/base/error.h"
#include "soms/tree/build.h"
#include "soms/tree/build/detail/subtrees.h"
#include "soms/tree/detail/held_mesh.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <utility>

namespace soms {

namespace {

std::size_t bytes_of(const MeshView& mesh) {
  return mesh.vertices.size_bytes() + mesh.triangles.size_bytes() + mesh.faces.size_bytes() +
         mesh.parts.capacity() * sizeof(Part);
}

std::size_t bytes_of(const Tree& tree) {
  return tree.nodes.capacity() * sizeof(Node) + tree.primitives.capacity() * sizeof(TriangleId);
}

/// Equal values, which may be one, or none.
template <class T>
bool equal(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && *a == *b);
}

}  // namespace

Shape::Shape()
    : mesh_(detail::HeldMesh::of(std::make_shared<const Mesh>())),
      layout_(std::make_shared<const WideTree>()) {
}

Shape::Shape(Mesh mesh, const ShapeOptions& options, const Limits& limits)
    : Shape(std::make_shared<const Mesh>(std::move(mesh)), options, limits) {
}

Shape::Shape(std::shared_ptr<const Mesh> mesh, const ShapeOptions& options, const Limits& limits)
    : build_options_(options.build) {
  if (!mesh) {
    throw Error(ErrorKind::usage, "shape: no mesh", "give a mesh; it may be empty");
  }
  check(*mesh);
  mesh_ = detail::HeldMesh::of(std::move(mesh));
  if (options.keep_tree) {
    tree_ =
        std::make_shared<const Tree>(build(*mesh_, options.build, detail::within(limits, 0, 0.6)));
    layout_ = std::make_shared<const WideTree>(*tree_, *mesh_, detail::within(limits, 0.6, 1));
  } else {
    layout_ = std::make_shared<const WideTree>(build_wide(*mesh_, options.build, limits));
  }
  if (options.layout == Layout::compact) {
    layout_ = std::make_shared<const WideTree>(layout_->compacted(limits));
  }
  bounds_ = layout_->bounds();
}

std::shared_ptr<const Mesh> Shape::shared_mesh() const {
  return static_cast<const detail::HeldMesh&>(*mesh_).shared();
}

const TreeFileName* Shape::tree_file() const {
  return static_cast<const detail::HeldMesh&>(*mesh_).tree_file();
}

Shape detail::opened(ShapeParts parts) {
  Shape shape;
  shape.mesh_ = std::move(parts.mesh);
  shape.layout_ = std::move(parts.layout);
  shape.bounds_ = shape.layout_->bounds();
  shape.build_options_ = parts.build_options;
  shape.sah_area_ratio_ = parts.sah_area_ratio;
  shape.sah_degradation_ = parts.sah_degradation;
  return shape;
}

std::pair<double, double> detail::areas_of(const Shape& shape) {
  return {shape.sah_area_ratio_, shape.sah_degradation_};
}

std::size_t Shape::memory() const {
  return bytes_of(*mesh_) + layout_->memory() + (tree_ ? bytes_of(*tree_) : 0);
}

std::size_t Shape::layout_memory() const {
  return layout_->memory();
}

Layout Shape::layout_kind() const {
  return layout_->compact() != nullptr ? Layout::compact : Layout::wide;
}

bool Shape::operator==(const Shape& other) const {
  return build_options_ == other.build_options_ && bounds_ == other.bounds_ &&
         sah_area_ratio_ == other.sah_area_ratio_ && sah_degradation_ == other.sah_degradation_ &&
         equal(mesh_, other.mesh_) && equal(tree_, other.tree_) && equal(layout_, other.layout_);
}

}  // namespace soms
