#include "soms/motion/detail/triangle_lanes.h"

#include <algorithm>

namespace soms::detail {

namespace {

/// Calls `each(row)` for all rows of numbers.
template <class Each>
void for_each_row(TriangleLanes& lanes, const Each& each) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 3; ++k) {
      each(lanes.corner[k][axis]);
      each(lanes.edge[k][axis]);
    }
    each(lanes.normal[axis]);
    each(lanes.change[axis]);
  }
  each(lanes.give);
}

}  // namespace

void gather_lanes(const MeshView& mesh, const TriangleBlock& block, TriangleLanes& lanes) {
  lanes.count = block.count;
  lanes.id = block.id;
  for (std::size_t lane = 0; lane < TriangleLanes::kLanes; ++lane) {
    const Triangle t = mesh.triangle(block.id[std::min<std::size_t>(lane, block.count - 1)]);
    const std::array<Vec3, 3> corners{t.a, t.b, t.c};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        lanes.corner[k][axis][lane] = corners[k][axis];
      }
    }
  }
}

void keep_lanes(std::uint32_t bits, TriangleLanes& lanes) {
  std::array<std::size_t, TriangleLanes::kLanes> from{};
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < lanes.count; ++lane) {
    from[count] = lane;
    count += bits >> lane & 1U;
  }
  if (count == lanes.count) {
    return;
  }
  std::fill(from.begin() + static_cast<std::ptrdiff_t>(count), from.end(), from[count - 1]);
  const auto pack = [&](auto& row) {
    for (std::size_t lane = 0; lane < TriangleLanes::kLanes; ++lane) {
      row[lane] = row[from[lane]];
    }
  };
  for_each_row(lanes, pack);
  pack(lanes.id);
  lanes.count = count;
}

}  // namespace soms::detail
