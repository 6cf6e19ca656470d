#include "soms/query/detail/near/keyed_pairs.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

void KeyedPairs::clear() {
  entries_.clear();
  filled_ = {};
  free_ = kNone;
  sorted_ = false;
}

std::size_t KeyedPairs::bucket_of(float key) const {
  const float at = (key - lower_) * scale_;
  return at >= static_cast<float>(kBuckets - 1) ? kBuckets - 1
         : at > 0                               ? static_cast<std::size_t>(at)
                                                : 0;
}

void KeyedPairs::put(const KeyedPair& pair) {
  const std::size_t bucket = bucket_of(pair.key);
  std::uint64_t& word = filled_[bucket / 64];
  const std::uint64_t bit = std::uint64_t{1} << bucket % 64;
  const Entry entry{pair, (word & bit) != 0 ? first_[bucket] : kNone};
  word |= bit;
  if (free_ != kNone) {
    first_[bucket] = free_;
    free_ = entries_[free_].next;
    entries_[first_[bucket]] = entry;
  } else {
    first_[bucket] = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back(entry);
  }
}

bool KeyedPairs::pop(float limit, KeyedPair& pair) {
  if (!sorted_) {
    while (!entries_.empty()) {
      pair = entries_.back().pair;
      entries_.pop_back();
      if (!(pair.key > limit)) {
        return true;
      }
    }
    return false;
  }
  for (std::size_t word = 0; word < filled_.size();) {
    if (filled_[word] == 0) {
      ++word;
      continue;
    }
    const std::size_t bucket =
        64 * word + static_cast<std::size_t>(std::countr_zero(filled_[word]));
    if (bucket > bucket_of(limit)) {
      return false;
    }
    const std::uint32_t at = first_[bucket];
    const std::uint32_t next = entries_[at].next;
    pair = entries_[at].pair;
    entries_[at].next = free_;
    free_ = at;
    first_[bucket] = next;
    if (next == kNone) {
      filled_[word] &= filled_[word] - 1;
    }
    if (!(pair.key > limit)) {
      return true;
    }
  }
  return false;
}

void KeyedPairs::sort(float lower, float upper) {
  lower_ = lower;
  scale_ = static_cast<float>(kBuckets - 1) / std::max(upper - lower, 0x1p-100F);
  sorted_ = true;
  stack_.clear();
  stack_.swap(entries_);
  for (const Entry& entry : stack_) {
    put(entry.pair);
  }
}

float KeyedPairs::least_left() const {
  float least = std::numeric_limits<float>::infinity();
  if (!sorted_) {
    for (const Entry& entry : entries_) {
      least = std::min(least, entry.pair.key);
    }
    return least;
  }
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    if ((filled_[bucket / 64] >> bucket % 64 & 1U) != 0) {
      for (std::uint32_t at = first_[bucket]; at != kNone; at = entries_[at].next) {
        least = std::min(least, entries_[at].pair.key);
      }
      return least;
    }
  }
  return least;
}

}  // namespace soms::detail
