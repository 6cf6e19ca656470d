/// \file
/// Sorting by counting: what the search for defects of large meshes is made of.
#pragma once

#include "soms/base/parallel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace soms::detail {

/// Runs loops that may be long: a stop ends them, and progress is reported for all of them
/// together.
class Work {
 public:
  /// \pre `total` > 0: the sum of all `count`s to come.
  Work(const Limits& limits, std::uint64_t total)
      : limits_(limits), total_(static_cast<double>(total)) {}

  /// Calls `body(i)` for 0 to count - 1, in order.
  template <class Body>
  void run(std::size_t count, const Body& body) {
    Limits one;
    one.stop = limits_.stop;
    if (limits_.progress) {
      one.progress = [&](double share) {
        limits_.progress((done_ + share * static_cast<double>(count)) / total_);
      };
    }
    for_each_chunk(count, std::size_t{1} << 16, one, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        body(i);
      }
    });
    done_ += static_cast<double>(count);
  }

  /// Counts work as done that ran elsewhere, or that turned out to be needless.
  void skip(std::size_t count) {
    check(limits_);
    done_ += static_cast<double>(count);
    if (limits_.progress) {
      limits_.progress(done_ / total_);
    }
  }

 private:
  const Limits& limits_;
  double total_;
  double done_ = 0;
};

/// Items sorted by a number: those of number k are items[offsets[k]] to items[offsets[k + 1]].
template <class Item>
struct Buckets {
  std::vector<std::uint64_t> offsets;
  std::vector<Item> items;

  [[nodiscard]] std::size_t size() const { return offsets.size() - 1; }

  [[nodiscard]] std::span<Item> operator[](std::size_t k) {
    return {items.data() + offsets[k], items.data() + offsets[k + 1]};
  }
};

/// Sorts what `each(i, put)` puts for i from 0 to count - 1, by calling `put(bucket, item)`, into
/// buckets 0 to `buckets` - 1; `each` runs twice for every i. Items of a bucket keep their order.
template <class Item, class Each>
[[nodiscard]] Buckets<Item> sort_into_buckets(std::size_t buckets, std::size_t count, Work& work,
                                              const Each& each) {
  Buckets<Item> result;
  // While items are placed, offsets[k + 1] is where the next one of bucket k goes.
  result.offsets.resize(buckets + 2);
  work.run(count, [&](std::size_t i) {
    each(i, [&](std::size_t bucket, const Item&) { ++result.offsets[bucket + 2]; });
  });
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.items.resize(result.offsets.back());
  work.run(count, [&](std::size_t i) {
    each(i, [&](std::size_t bucket, const Item& item) {
      result.items[result.offsets[bucket + 1]++] = item;
    });
  });
  result.offsets.pop_back();
  return result;
}

/// The least values among all that are added, at most `most` of them.
template <class Value>
class Least {
 public:
  explicit Least(std::size_t most) : most_(most) {}

  void add(const Value& value) {
    if (heap_.size() < most_) {
      heap_.push_back(value);
      std::push_heap(heap_.begin(), heap_.end());
    } else if (most_ > 0 && value < heap_.front()) {
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.back() = value;
      std::push_heap(heap_.begin(), heap_.end());
    }
  }

  /// The values, least first; leaves none.
  [[nodiscard]] std::vector<Value> take() {
    std::sort_heap(heap_.begin(), heap_.end());
    return std::move(heap_);
  }

 private:
  std::size_t most_;
  std::vector<Value> heap_;
};

}  // namespace soms::detail
