/// \file
/// Pairs of nodes that a query of nearness has still to look at, the nearest first.
#pragma once

#include "soms/query/detail/engine/pair_list.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms::detail {

/// A pair of node ids (see NodeTask) with a lower bound of its distance.
struct KeyedPair {
  float key;
  NodeRefPair nodes;
};

/// A stack until the first distance is known; from then on buckets by key, the last one in a bucket
/// first out (Dial 1969). What lies beyond the limit is dropped, and the least key of it
/// remembered.
class KeyedPairs {
 public:
  void clear();

  void push(const KeyedPair& pair) {
    if (sorted_) {
      put(pair);
    } else {
      entries_.push_back({pair, kNone});
    }
  }

  /// Takes the next pair whose key does not exceed `limit`; false if there is none.
  [[nodiscard]] bool pop(float limit, KeyedPair& pair);

  /// Goes over to buckets from `lower` to `upper`: what was pushed is sorted into them.
  void sort(float lower, float upper);

  [[nodiscard]] bool sorted() const { return sorted_; }

  /// The least key of the pairs that are left; infinity if none is. \cost O(n)
  [[nodiscard]] float least_left() const;

 private:
  static constexpr std::size_t kBuckets = 256;
  static constexpr std::uint32_t kNone = 0xffffffffU;

  struct Entry {
    KeyedPair pair;
    std::uint32_t next;
  };

  [[nodiscard]] std::size_t bucket_of(float key) const;
  void put(const KeyedPair& pair);

  std::vector<Entry> entries_;
  std::vector<Entry> stack_;  // what was pushed before sorting
  std::array<std::uint32_t, kBuckets> first_ = {};
  std::array<std::uint64_t, kBuckets / 64> filled_ = {};
  std::uint32_t free_ = kNone;
  bool sorted_ = false;
  float lower_ = 0;
  float scale_ = 0;
};

}  // namespace soms::detail
