#include "soms/scene/detail/box_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::detail {

namespace {

constexpr unsigned kRankBits = 19;
constexpr int kClasses = 64;

/// Spreads the low 21 bits of `v` to every third bit.
std::uint64_t spread(std::uint64_t v) {
  v = (v | (v << 32)) & 0x001f00000000ffffULL;
  v = (v | (v << 16)) & 0x001f0000ff0000ffULL;
  v = (v | (v << 8)) & 0x100f00f00f00f00fULL;
  v = (v | (v << 4)) & 0x10c30c30c30c30c3ULL;
  return (v | (v << 2)) & 0x1249249249249249ULL;
}

/// Which power of two the longest side reaches.
int exponent(const Box& box) {
  const Vec3 extent = box.extent();
  const double longest = std::max({extent.x, extent.y, extent.z});
  return longest > 0 ? std::ilogb(longest) : std::numeric_limits<double>::min_exponent - 53;
}

}  // namespace

/// Keys: the class of size first, so that no small box lies in a group with a large one; then the
/// place on a Morton curve over ranks along the axes instead of coordinates, so that boxes far away
/// do not squeeze the others into one cell.
void BoxIndex::make_keys(std::span<const Box> boxes) {
  keys_.clear();
  int largest = std::numeric_limits<int>::min();
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    if (!boxes[k].empty()) {
      keys_.emplace_back(0, k);
      largest = std::max(largest, exponent(boxes[k]));
    }
  }
  for (auto& [key, k] : keys_) {
    const int smaller = std::min(largest - exponent(boxes[k]), kClasses - 1);
    key = static_cast<std::uint64_t>(smaller) << (3 * kRankBits);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ranks_.clear();
    for (std::uint32_t place = 0; place < keys_.size(); ++place) {
      ranks_.emplace_back(boxes[keys_[place].second].center()[axis], place);
    }
    std::sort(ranks_.begin(), ranks_.end());
    std::uint64_t rank = 0;
    for (std::size_t k = 0; k < ranks_.size(); ++k) {
      if (k > 0 && ranks_[k].first > ranks_[k - 1].first) {
        rank = k;
      }
      keys_[ranks_[k].second].first |= spread((rank << kRankBits) / ranks_.size()) << axis;
    }
  }
  std::sort(keys_.begin(), keys_.end());
}

void BoxIndex::build(std::span<const Box> boxes, std::span<const std::uint32_t> groups) {
  order_.clear();
  bounds_.clear();
  groups_.clear();
  levels_.clear();
  make_keys(boxes);
  give_back(keys_);
  give_back(ranks_);
  if (keys_.empty()) {
    give_back(order_);
    give_back(bounds_);
    give_back(groups_);
    return;
  }
  for (const auto& [key, k] : keys_) {
    order_.push_back(k);
    bounds_.push_back(boxes[k]);
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
  if (!groups.empty()) {
    unite_groups(groups);
  }
  give_back(order_);
  give_back(bounds_);
  give_back(groups_);
}

/// A node's group is that of all boxes below it, or none.
void BoxIndex::unite_groups(std::span<const std::uint32_t> groups) {
  groups_.reserve(bounds_.size());
  for (const std::uint32_t k : order_) {
    groups_.push_back(k < groups.size() ? groups[k] : 0);
  }
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    const Level below = levels_[level - 1];
    for (std::size_t node = 0; node < levels_[level].count; ++node) {
      const std::size_t begin = below.first + node * kGroup;
      const std::size_t end = below.first + std::min(below.count, (node + 1) * kGroup);
      bool alike = true;
      for (std::size_t k = begin + 1; k < end; ++k) {
        alike = alike && groups_[k] == groups_[begin];
      }
      groups_.push_back(alike ? groups_[begin] : 0);
    }
  }
}

}  // namespace soms::detail
