#include "reproduce/alternative_rules.h"

#include "soms/tree/rule/rules.h"

#include <algorithm>
#include <vector>

namespace soms::reproduce {

namespace {

bool divides(const SplitNode& node, const Split& split) {
  const auto left = [&](const Primitive& primitive) { return split.is_left(primitive); };
  return std::any_of(node.primitives.begin(), node.primitives.end(), left) &&
         !std::all_of(node.primitives.begin(), node.primitives.end(), left);
}

/// The first of x, y and z with the greatest extent.
std::size_t longest_axis(const Box& box) {
  const Vec3 extent = box.extent();
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    axis = extent[k] > extent[axis] ? k : axis;
  }
  return axis;
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

}  // namespace soms::reproduce
