#include "soms/scene/detail/pair_filter.h"

#include <algorithm>

namespace soms::detail {

PairFilter::PairFilter(std::vector<std::uint32_t> groups,
                       std::span<const std::pair<std::uint32_t, std::uint32_t>> ignored)
    : groups_(std::move(groups)) {
  if (std::all_of(groups_.begin(), groups_.end(), [](std::uint32_t group) { return group == 0; })) {
    release(groups_);
  }
  std::vector<std::uint64_t> pairs;
  pairs.reserve(ignored.size());
  std::uint64_t rows = 0;
  for (const auto& [a, b] : ignored) {
    const std::uint64_t row = std::min(a, b);
    pairs.push_back(row << 32 | std::max(a, b));
    rows = std::max(rows, row + 1);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  ignored_.assign(rows, pairs);
}

bool PairFilter::holds(std::span<const std::uint32_t> sorted, std::uint32_t value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

}  // namespace soms::detail
