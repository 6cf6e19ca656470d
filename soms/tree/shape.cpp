#include "soms/tree/shape.h"

#include "soms/base/error.h"
#include "soms/tree/build.h"
#include "soms/tree/build/detail/subtrees.h"
#include "soms/tree/layout/wide_tree.h"

#include <utility>

namespace soms {

namespace {

std::size_t bytes_of(const Mesh& mesh) {
  return mesh.vertices.capacity() * sizeof(Vec3) +
         mesh.triangles.capacity() * sizeof(mesh.triangles[0]) +
         mesh.faces.capacity() * sizeof(mesh.faces[0]) + mesh.parts.capacity() * sizeof(Part);
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
    : mesh_(std::make_shared<const Mesh>()), layout_(std::make_shared<const WideTree>()) {
}

Shape::Shape(Mesh mesh, const ShapeOptions& options, const Parallel& parallel)
    : Shape(std::make_shared<const Mesh>(std::move(mesh)), options, parallel) {
}

Shape::Shape(std::shared_ptr<const Mesh> mesh, const ShapeOptions& options,
             const Parallel& parallel)
    : mesh_(std::move(mesh)), build_options_(options.build) {
  if (!mesh_) {
    throw Error(ErrorKind::usage, "shape: no mesh", "give a mesh; it may be empty");
  }
  check(*mesh_);
  if (options.keep_tree) {
    tree_ = std::make_shared<const Tree>(
        build(*mesh_, options.build, detail::within(parallel, 0, 0.6)));
    layout_ = std::make_shared<const WideTree>(*tree_, *mesh_, detail::within(parallel, 0.6, 1));
  } else {
    layout_ = std::make_shared<const WideTree>(build_wide(*mesh_, options.build, parallel));
  }
  if (options.layout == Layout::compact) {
    layout_ = std::make_shared<const WideTree>(layout_->compacted(parallel));
  }
  bounds_ = layout_->bounds();
}

std::size_t Shape::memory() const {
  return bytes_of(*mesh_) + layout_->memory() + (tree_ ? bytes_of(*tree_) : 0);
}

bool Shape::operator==(const Shape& other) const {
  return build_options_ == other.build_options_ && bounds_ == other.bounds_ &&
         sah_area_ratio_ == other.sah_area_ratio_ && sah_degradation_ == other.sah_degradation_ &&
         equal(mesh_, other.mesh_) && equal(tree_, other.tree_) && equal(layout_, other.layout_);
}

}  // namespace soms
