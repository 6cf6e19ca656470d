/// \file
/// Sets of numbers that grow together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace soms::detail {

/// Each number below `size` in a set of its own, until sets are united.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : above_(size) {
    std::iota(above_.begin(), above_.end(), 0U);
  }

  /// The least number of the set.
  [[nodiscard]] std::uint32_t find(std::uint32_t v) {
    while (above_[v] != v) {
      above_[v] = above_[above_[v]];
      v = above_[v];
    }
    return v;
  }

  void unite(std::uint32_t v, std::uint32_t w) {
    v = find(v);
    w = find(w);
    // The lesser one stays, and paths are halved: logarithmic on average, whatever the order.
    above_[std::max(v, w)] = std::min(v, w);
  }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace soms::detail
