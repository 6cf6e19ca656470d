#include "soms/query/detail/block_against_box.h"

#include "soms/query/detail/kernels/instruction_set.h"

#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

/// Fills in the radii.
void finish(SeenBox& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.radius[i] =
        ((std::abs(box.axis[i][0]) * box.half[0] + std::abs(box.axis[i][1]) * box.half[1]) +
         std::abs(box.axis[i][2]) * box.half[2]) +
        (box.margin + box.reach);
  }
}

}  // namespace

SeenBox seen_by_y(const BoxRelation& relation, const std::array<float, 3>& half_x, float reach) {
  const float ratio = relation.ratio;
  SeenBox box;
  box.center = relation.offset;
  box.half = {half_x[0] * ratio, half_x[1] * ratio, half_x[2] * ratio};
  box.axis = relation.turn->entry;
  box.margin = relation.margin;
  box.reach = reach;
  finish(box);
  return box;
}

SeenBox seen_by_x(const BoxRelation& relation, const std::array<float, 3>& half_y, float reach) {
  const auto& n = relation.turn->entry;
  const auto& d = relation.offset;
  SeenBox box;
  for (std::size_t j = 0; j < 3; ++j) {
    box.center[j] = -((n[0][j] * d[0] + n[1][j] * d[1]) + n[2][j] * d[2]);
    box.axis[j] = {n[0][j], n[1][j], n[2][j], 0};
  }
  box.half = half_y;
  box.margin = relation.margin;
  box.reach = reach;
  finish(box);
  return box;
}

std::uint32_t box_against_y(const BoxRelation& relation, const std::array<float, 3>& half_x,
                            const TriangleBlock& y, float reach) {
  return kernels().meet_box(seen_by_y(relation, half_x, reach), y, 1);
}

std::uint32_t box_against_x(const BoxRelation& relation, const TriangleBlock& x,
                            const std::array<float, 3>& half_y, float reach) {
  return kernels().meet_box(seen_by_x(relation, half_y, reach), x, relation.ratio);
}

}  // namespace soms::detail
