#include "soms/query/detail/leaf_pairs.h"

#include "soms/geometry/triangle_overlap.h"
#include "soms/query/detail/kernels/instruction_set.h"

#include <bit>

namespace soms::detail {

namespace {

Triangle moved(const WalkSide& side, TriangleId id) {
  const Triangle t = side.shape->mesh().triangle(id);
  return {side.pose->apply(t.a), side.pose->apply(t.b), side.pose->apply(t.c)};
}

}  // namespace

bool LeafPairs::decide(std::span<const BlockTask> tasks, Collector& collector, Cost& cost) {
  for (const BlockTask& task : tasks) {
    if (task.lanes_x == 0 || task.lanes_y == 0) {
      continue;
    }
    cost.node_tests += task.x->count;
    const std::uint64_t rows = kernels().test_triangles(task);
    if (rows != 0 && decide(task, rows, collector, cost)) {
      return true;
    }
  }
  return false;
}

bool LeafPairs::decide(const BlockTask& task, std::uint64_t rows, Collector& collector,
                       Cost& cost) {
  for (std::size_t i = 0; rows >> (8 * i) != 0; ++i) {
    const auto lanes = static_cast<std::uint32_t>(rows >> (8 * i) & 0xff);
    if (lanes != 0 && decide(task.x->id[i], *task.y, lanes, collector, cost)) {
      return true;
    }
    if (i == TriangleBlock::kWidth - 1) {
      break;
    }
  }
  return false;
}

bool LeafPairs::decide(TriangleId i, const TriangleBlock& y, std::uint32_t lanes,
                       Collector& collector, Cost& cost) {
  const Triangle s = moved(x_, i);
  const Box box = bounds(s);
  for (; lanes != 0; lanes &= lanes - 1) {
    const TriangleId j = y.id[static_cast<std::size_t>(std::countr_zero(lanes))];
    const TrianglePair ids = swapped_ ? TrianglePair{j, i} : TrianglePair{i, j};
    if (!collector.wants(ids)) {
      continue;
    }
    const Triangle t = moved(y_, j);
    if (!overlaps(box, bounds(t))) {
      continue;
    }
    ++cost.triangle_tests;
    if (triangles_overlap(s, t, &cost.exact_tests) && collector.add(ids)) {
      return true;
    }
  }
  return false;
}

}  // namespace soms::detail
