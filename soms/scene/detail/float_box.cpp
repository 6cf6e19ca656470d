#include "soms/scene/detail/float_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::size_t kBoxesOfSample = 128;

}  // namespace

FloatMap FloatMap::of(std::span<const Box> boxes) {
  std::array<std::vector<double>, 3> centers;
  const std::size_t stride = boxes.size() / kBoxesOfSample + 1;
  Vec3 most;
  for (std::size_t k = 0; k < boxes.size(); k += stride) {
    if (boxes[k].empty()) {
      continue;
    }
    const Vec3 center = boxes[k].center();
    const Vec3 extent = boxes[k].extent();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      centers[axis].push_back(center[axis]);
      most[axis] = std::max(most[axis], extent[axis]);
    }
  }
  FloatMap map;
  double width = 0;
  const std::size_t count = centers[0].size();
  for (std::size_t axis = 0; axis < 3 && count > 0; ++axis) {
    std::sort(centers[axis].begin(), centers[axis].end());
    map.origin[axis] = centers[axis][count / 2];
    width = std::max(width, centers[axis][count - 1 - count / 8] - centers[axis][count / 8]);
  }
  if (!(width > 0)) {
    width = std::max({most.x, most.y, most.z});
  }
  // A power of two, so that scaling is exact.
  map.scale = width > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(width), -1000, 1000)) : 1;
  return map;
}

bool FloatMap::serves(const FloatMap& other) const {
  constexpr double kMostShift = 0.25;  // of the width
  const double ratio = scale / other.scale;
  const auto near = [&](double a, double b) { return std::abs(a - b) * scale <= kMostShift; };
  return ratio >= 0.5 && ratio <= 2 && near(origin.x, other.origin.x) &&
         near(origin.y, other.origin.y) && near(origin.z, other.origin.z);
}

}  // namespace soms::detail
