#include "soms/query/detail/overlap_query.h"

#include <algorithm>

namespace soms::detail {

bool first_is_reference(const WideTree& a, const WideTree& b) {
  if (a.exponent() != b.exponent()) {
    return a.exponent() < b.exponent();
  }
  const auto size = [](const WideTree& tree) {
    const Vec3 extent = tree.bounds().extent();
    return std::max({extent.x, extent.y, extent.z});
  };
  return size(a) > size(b);
}

bool is_empty(const Shape& shape) {
  return shape.layout().empty();
}

bool any_compact(const Shape& a, const Shape& b) {
  return a.layout().compact() != nullptr || b.layout().compact() != nullptr;
}

void check_pose(const Pose& pose, const Shape& shape) {
  check(pose);
  check_range(pose, shape.bounds());
}

Coverage coverage_of(OverlapMode mode, const Collector& collector, bool late) {
  if (collector.full()) {
    return Coverage::cut;
  }
  if (mode == OverlapMode::any && collector.any()) {
    return Coverage::first;
  }
  if (late) {
    return Coverage::cut;
  }
  return mode == OverlapMode::first && collector.any() ? Coverage::first : Coverage::complete;
}

}  // namespace soms::detail
