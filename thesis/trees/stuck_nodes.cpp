#include "thesis/trees/stuck_nodes.h"

#include <algorithm>
#include <span>

namespace soms::reproduce {

namespace {

bool has_one_midpoint(std::span<const TriangleId> triangles, const Mesh& mesh,
                      const BuildOptions& options) {
  const auto midpoint_of = [&](TriangleId id) {
    return midpoint(mesh.triangle(id), options.midpoint, options.c_vertex);
  };
  return std::all_of(triangles.begin(), triangles.end(), [&](TriangleId id) {
    return midpoint_of(id) == midpoint_of(triangles.front());
  });
}

}  // namespace

StuckNodes stuck_nodes(const Tree& tree, const Mesh& mesh, const BuildOptions& options) {
  StuckNodes stuck;
  for (const Node& node : tree.nodes) {
    if (node.undividable) {
      ++stuck.all;
      stuck.partable += has_one_midpoint(tree.triangles_of(node), mesh, options) ? 0U : 1U;
      stuck.largest = std::max(stuck.largest, std::uint64_t{node.count});
    }
  }
  return stuck;
}

}  // namespace soms::reproduce
