#include "soms/scene/detail/box_index.h"

#include <algorithm>

namespace soms::detail {

namespace {

/// Spreads the low 10 bits of `v` to every third bit.
std::uint32_t spread(std::uint32_t v) {
  v = (v | (v << 16)) & 0x030000ffU;
  v = (v | (v << 8)) & 0x0300f00fU;
  v = (v | (v << 4)) & 0x030c30c3U;
  return (v | (v << 2)) & 0x09249249U;
}

/// Place on the Morton curve of 1024 cells a side over `all`.
std::uint32_t place(const Vec3& center, const Box& all) {
  std::uint32_t code = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = all.upper[axis] - all.lower[axis];
    const double share = extent > 0 ? (center[axis] - all.lower[axis]) / extent : 0;
    const auto cell = static_cast<std::uint32_t>(std::clamp(share, 0.0, 1.0) * 1023);
    code |= spread(cell) << axis;
  }
  return code;
}

}  // namespace

void BoxIndex::build(std::span<const Box> boxes) {
  order_.clear();
  bounds_.clear();
  levels_.clear();
  keys_.clear();
  Box all;
  for (const Box& box : boxes) {
    if (!box.empty()) {
      all.grow(box);
    }
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (!boxes[k].empty()) {
      keys_.push_back((std::uint64_t{place(boxes[k].center(), all)} << 32) | k);
    }
  }
  if (keys_.empty()) {
    return;
  }
  std::sort(keys_.begin(), keys_.end());
  for (const std::uint64_t key : keys_) {
    order_.push_back(static_cast<std::uint32_t>(key));
    bounds_.push_back(boxes[order_.back()]);
  }
  levels_.push_back({0, order_.size()});
  while (levels_.back().count > 1) {
    const Level below = levels_.back();
    const Level above{below.first + below.count, (below.count - 1) / kGroup + 1};
    for (std::size_t group = 0; group < above.count; ++group) {
      Box box;
      const std::size_t end = std::min(below.count, (group + 1) * kGroup);
      for (std::size_t k = group * kGroup; k < end; ++k) {
        box.grow(bounds_[below.first + k]);
      }
      bounds_.push_back(box);
    }
    levels_.push_back(above);
  }
}

}  // namespace soms::detail
