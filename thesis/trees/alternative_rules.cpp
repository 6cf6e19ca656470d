#include "thesis/trees/alternative_rules.h"

#include "soms/geometry/midpoint.h"
#include "soms/tree/rule/rules.h"

#include "thesis/trees/divided_tree.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace soms::reproduce {

namespace {

bool divides(const SplitNode& node, const Split& split) {
  const auto left = [&](const Primitive& primitive) { return split.is_left(primitive); };
  return std::any_of(node.primitives.begin(), node.primitives.end(), left) &&
         !std::all_of(node.primitives.begin(), node.primitives.end(), left);
}

Vec3 thesis_midpoint(const Mesh& mesh, TriangleId id) {
  return midpoint(mesh.triangle(id), Midpoint::thesis, 2);
}

/// What `corner_pair` compares: a triangle's extent on the axis.
struct Extent {
  double lower;
  double upper;
};

Extent extent_of(const Mesh& mesh, TriangleId id, std::size_t axis) {
  const Box box = bounds(mesh.triangle(id));
  return {box.lower[axis], box.upper[axis]};
}

}  // namespace

Split middle_pair(const SplitNode& node, std::size_t axis) {
  std::vector<double> sorted;
  sorted.reserve(node.primitives.size());
  for (const Primitive& primitive : node.primitives) {
    sorted.push_back(primitive.midpoint[axis]);
  }
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  const double plane = 0.5 * (sorted[half - 1] + sorted[half]);
  if (plane > sorted.front()) {
    return {axis, plane};
  }
  const auto next = std::upper_bound(sorted.begin(), sorted.end(), sorted.front());
  return {axis, next == sorted.end() ? plane : *next};
}

Split spatial_then_soms(const SplitNode& node, std::size_t axis) {
  const Split spatial = rule::spatial_median(node, axis);
  return divides(node, spatial) ? spatial : rule::soms(node, longest_axis(node.inner));
}

Split corner_pair(const Mesh& mesh, std::span<const TriangleId> triangles) {
  Box inner;
  for (const TriangleId id : triangles) {
    inner.grow(thesis_midpoint(mesh, id));
  }
  const std::size_t axis = longest_axis(inner);
  const TriangleId least =
      *std::min_element(triangles.begin(), triangles.end(), [&](TriangleId i, TriangleId j) {
        return extent_of(mesh, i, axis).lower < extent_of(mesh, j, axis).lower;
      });
  const TriangleId greatest =
      *std::max_element(triangles.begin(), triangles.end(), [&](TriangleId i, TriangleId j) {
        return extent_of(mesh, i, axis).upper < extent_of(mesh, j, axis).upper;
      });
  return {axis, 0.5 * (thesis_midpoint(mesh, least)[axis] + thesis_midpoint(mesh, greatest)[axis])};
}

Tree corner_pair_tree(const Mesh& mesh, int level) {
  const auto divide = [&](std::span<TriangleId> triangles, const Box& /*outer*/) {
    const Split split = corner_pair(mesh, triangles);
    const auto is_left = [&](TriangleId id) {
      return thesis_midpoint(mesh, id)[split.axis] < split.value;
    };
    const auto right = std::stable_partition(triangles.begin(), triangles.end(), is_left);
    return right == triangles.end() ? 0U : static_cast<std::uint32_t>(right - triangles.begin());
  };
  return divided_tree(mesh, divide, level);
}

}  // namespace soms::reproduce
