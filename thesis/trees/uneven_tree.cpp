#include "thesis/trees/uneven_tree.h"

#include "soms/geometry/midpoint.h"

#include "thesis/trees/divided_tree.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soms::reproduce {

Tree uneven_tree(const MeshView& mesh, double share) {
  std::vector<Vec3> midpoints;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    midpoints.push_back(midpoint(mesh.triangle(i), Midpoint::thesis, 2));
  }
  return divided_tree(mesh, [&](std::span<TriangleId> triangles, const Box& outer) {
    const std::size_t axis = longest_axis(outer);
    std::sort(triangles.begin(), triangles.end(), [&](TriangleId i, TriangleId j) {
      return std::pair(midpoints[i][axis], i) < std::pair(midpoints[j][axis], j);
    });
    const auto count = static_cast<std::uint32_t>(triangles.size());
    return std::clamp<std::uint32_t>(static_cast<std::uint32_t>(share * count), 1, count - 1);
  });
}

}  // namespace soms::reproduce
