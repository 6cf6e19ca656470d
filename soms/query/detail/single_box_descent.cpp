#include "soms/query/detail/single_box_descent.h"

#include "soms/query/detail/engine/fetch.h"
#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/query_lanes.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace soms::detail {

namespace {

/// A tree of at least so many times the box's size is descended by the box alone.
constexpr float kMuchLarger = 8;
constexpr float kMargin = BoxNumbers::kMargin;

}  // namespace

void SingleBox::take(const RelativePoses& poses, std::size_t i, bool placed) {
  for (std::size_t k = 0; k < 3; ++k) {
    center[k] = poses.shift[k][i];
    half[k] = poses.half[k][i];
  }
  size = std::max({half[0], half[1], half[2]});
  sum = poses.sum[i];
  slack = poses.slack[i];
  scale = poses.scale[i];
  if (!placed) {
    return;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    place.from[k] = static_cast<std::uint32_t>(static_cast<std::int32_t>(poses.from[k][i]));
    place.to[k] = static_cast<std::uint32_t>(static_cast<std::int32_t>(poses.to[k][i]));
  }
  place.lower = poses.lower[i];
  place.upper = poses.upper[i];
}

bool SingleBox::pays(const WideNode& root) const {
  // Where rounding outweighs a body, every box would meet every other.
  return scale != 0 && root.l1_radius > kMuchLarger * sum;
}

void SingleBox::find_place(const WideTree& y) {
  if (y.min_max_grid().empty()) {
    return;
  }
  const auto margin = static_cast<double>(kMargin * sum + slack);
  std::array<double, 3> at;
  std::array<double, 3> half_extent;
  for (std::size_t i = 0; i < 3; ++i) {
    at[i] = center[i] * scale;
    half_extent[i] = static_cast<double>(half[i]) + margin;
  }
  y.min_max_grid().plan().place(at, half_extent, place);
}

bool SingleBox::clear_of(const WideTree& y) const {
  const layout::MinMaxGrid& grid = y.min_max_grid();
  return !grid.empty() && grid.clear(place);
}

std::uint32_t SingleBox::meets(const WideNode& node) const {
  const float margin = kMargin * (sum + node.l1_radius) + slack;
  M4 apart = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto offset = static_cast<float>((center[i] - node.origin[i]) * scale);
    apart |=
        abs(load(node.center[i]) - splat(offset)) > load(node.half[i]) + splat(half[i] + margin);
  }
  return ~bits_of(apart) & ((1U << node.count) - 1);
}

bool SingleBox::begin(const WideTree& y, std::uint32_t& index, PairList& stack) const {
  index = 0;
  if (y.min_max_grid().empty()) {
    return true;
  }
  const auto starts = y.start_nodes().of(place);
  for (const std::uint32_t start : starts) {
    fetch(y.nodes()[start]);
    stack.push({0, start});
  }
  if (starts.empty()) {
    return false;
  }
  index = stack.pop().y;
  return true;
}

void SingleBox::descend(const WideTree& y, PairList& stack, PairList& seeds, Cost& cost) const {
  std::uint32_t index = 0;
  bool going = begin(y, index, stack);
  while (going) {
    going = step(y.nodes().data(), index, stack, seeds, cost);
  }
}

bool SingleBox::step(const WideNode* nodes, std::uint32_t& index, PairList& stack, PairList& seeds,
                     Cost& cost) const {
  const WideNode& node = nodes[index];
  std::uint32_t inner = 0;
  if (node.oriented != 0) {
    seeds.push({kRootId, node_id_of(index)});
  } else {
    cost.node_tests += node.count;
    const F4 longest = max(max(load(node.half[0]), load(node.half[1])), load(node.half[2]));
    const std::uint32_t ends = node.leaves | bits_of(longest <= splat(size));
    const std::uint32_t meet = meets(node);
    inner = meet & ~ends;
    for (std::uint32_t left = meet & ends; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      seeds.push({kRootId, child_id(node, node_id_of(index), lane)});
    }
  }
  // Mostly one child goes on: it takes no way through memory.
  if (inner != 0) {
    index = node.child[static_cast<std::size_t>(std::countr_zero(inner))];
    for (inner &= inner - 1; inner != 0; inner &= inner - 1) {
      stack.push({0, node.child[static_cast<std::size_t>(std::countr_zero(inner))]});
    }
  } else if (!stack.empty()) {
    index = stack.pop().y;
  } else {
    return false;
  }
  fetch(nodes[index]);
  return true;
}

}  // namespace soms::detail
