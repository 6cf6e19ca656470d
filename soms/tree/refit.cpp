#include "soms/tree/refit.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/tree/detail/held_mesh.h"
#include "soms/tree/layout/detail/fetch_corners.h"
#include "soms/tree/layout/detail/parts.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace soms {

namespace {

/// In place of a ratio measured for a mesh without area.
constexpr double kNoArea = -1;
constexpr double kEndless = std::numeric_limits<double>::infinity();

void expect_as_many(std::size_t now, std::size_t before, const std::string& what) {
  if (now != before) {
    throw Error(
        ErrorKind::usage,
        "refit: " + std::to_string(now) + " " + what + " in place of " + std::to_string(before),
        "build a new shape");
  }
}

/// Boxes of `nodes`, the first of which is number `first` of the tree; the last node comes first.
void bound_part(std::span<Node> nodes, std::uint32_t first, std::span<const TriangleId> primitives,
                const MeshView& mesh) {
  const Node& root = nodes.front();
  layout::fetch_corners(mesh, primitives.subspan(root.first, root.count));
  for (std::size_t i = nodes.size(); i-- > 0;) {
    Node& node = nodes[i];
    node.bounds = {};
    if (node.is_leaf()) {
      for (const TriangleId id : primitives.subspan(node.first, node.count)) {
        node.bounds.grow(bounds(mesh.triangle(id)));
      }
    } else {
      node.bounds.grow(nodes[node.left - first].bounds);
      node.bounds.grow(nodes[node.right - first].bounds);
    }
  }
}

}  // namespace

Tree refit(const Tree& tree, const MeshView& mesh, const Limits& limits) {
  const PlainArithmetic plain;
  expect_as_many(mesh.triangles.size(), tree.primitives.size(), "triangles");
  check(mesh);
  check(limits);
  Tree moved = tree;
  if (moved.nodes.empty()) {
    return moved;
  }
  const layout::Cut parts = layout::cut(tree);
  for_each_chunk(parts.parts.size(), 1, limits, [&](std::size_t k, std::size_t) {
    const layout::Cut::Range& part = parts.parts[k];
    bound_part(std::span(moved.nodes).subspan(part.begin, part.end - part.begin), part.begin,
               moved.primitives, mesh);
  });
  // Upper nodes are those of more triangles that have children; their children follow them.
  for (std::size_t i = moved.nodes.size(); i-- > 0;) {
    Node& node = moved.nodes[i];
    if (node.count > layout::kPartTriangles && !node.is_leaf()) {
      node.bounds = moved.nodes[node.left].bounds;
      node.bounds.grow(moved.nodes[node.right].bounds);
    }
  }
  return moved;
}

Shape refit(const Shape& shape, std::shared_ptr<const Mesh> mesh, const Limits& limits) {
  const PlainArithmetic plain;
  if (!mesh) {
    throw Error(ErrorKind::usage, "refit: no mesh", "give the mesh that moved");
  }
  expect_as_many(mesh->vertices.size(), shape.mesh().vertices.size(), "vertices");
  expect_as_many(mesh->triangles.size(), shape.mesh().triangles.size(), "triangles");
  if (!std::equal(mesh->triangles.begin(), mesh->triangles.end(), shape.mesh().triangles.begin())) {
    throw Error(ErrorKind::usage, "refit: the triangles are not those of the shape",
                "build a new shape");
  }
  check(*mesh);
  check(limits);
  Shape moved = shape;
  moved.mesh_ = detail::HeldMesh::of(std::move(mesh));
  moved.layout_ = std::make_shared<const WideTree>(shape.layout(), moved.mesh(), limits);
  if (shape.tree_) {
    moved.tree_ = std::make_shared<const Tree>(refit(*shape.tree_, moved.mesh(), limits.silent()));
  }
  moved.bounds_ = moved.layout_->bounds();
  if (moved.sah_area_ratio_ == 0) {
    const double built = shape.layout().sah_area_ratio(shape.mesh(), limits);
    moved.sah_area_ratio_ = built > 0 ? built : kNoArea;
  }
  const double now = moved.layout_->sah_area_ratio(moved.mesh(), limits);
  if (now > 0) {
    // What was built of a mesh without area knows nothing of where triangles lie.
    moved.sah_degradation_ = moved.sah_area_ratio_ > 0 ? now / moved.sah_area_ratio_ : kEndless;
  } else {
    moved.sah_degradation_ = 1;
  }
  return moved;
}

Shape refit(const Shape& shape, std::vector<Vec3> vertices, const Limits& limits) {
  expect_as_many(vertices.size(), shape.mesh().vertices.size(), "vertices");
  MeshView moved = shape.mesh();
  moved.vertices = {};
  auto mesh = std::make_shared<Mesh>(static_cast<Mesh>(moved));
  mesh->vertices = std::move(vertices);
  return refit(shape, std::shared_ptr<const Mesh>(std::move(mesh)), limits);
}

}  // namespace soms
