/// \file
/// Batches of queries, whatever they ask: poses are checked, shared out in blocks, and answered
/// into columns.
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/pose.h"
#include "soms/query/answer.h"
#include "soms/tree/shape.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace soms::detail {

/// Poses that a thread takes at a time.
inline constexpr std::size_t kPosesOfBlock = 256;

/// Throws unless every pose is rigid and keeps the shape within range. An error names the first
/// pose at fault by its index.
void check_poses(std::span<const Pose> poses, const Shape& shape);

/// Memories that threads take while they work and give back, so that each makes one at most.
template <class Memory>
class MemoryPool {
 public:
  struct Place {
    template <class Make>
    explicit Place(const Make& make) : memory(make()) {}

    Memory memory;
  };

  template <class Make>
  [[nodiscard]] std::unique_ptr<Place> take(const Make& make) {
    {
      const std::scoped_lock lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<Place> place = std::move(free_.back());
        free_.pop_back();
        return place;
      }
    }
    return std::make_unique<Place>(make);
  }

  void give_back(std::unique_ptr<Place> place) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(place));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Place>> free_;
};

/// Calls `ask(memory, begin, end)` for blocks of kPosesOfBlock of `count` poses, the last one maybe
/// smaller, on any thread in any order. `make_memory()` makes what a thread's blocks share.
/// \errors Those of `ask`; ErrorKind::cancelled.
template <class MakeMemory, class Ask>
void for_each_block(std::size_t count, const Limits& limits, const MakeMemory& make_memory,
                    const Ask& ask) {
  MemoryPool<decltype(make_memory())> pool;
  for_each_chunk(count, kPosesOfBlock, limits.without_deadline(),
                 [&](std::size_t begin, std::size_t end) {
                   auto place = pool.take(make_memory);
                   ask(place->memory, begin, end);
                   pool.give_back(std::move(place));
                 });
}

/// Checks all poses of a shape, then calls `ask(memory, pose, i)` for each, as `for_each_block`
/// does. Answers of a fixed size are written to entry `i` of columns that are large enough already.
/// \errors As `check_poses`, before any query; then those of `ask`; ErrorKind::cancelled.
template <class MakeMemory, class Ask>
void for_each_pose(std::span<const Pose> poses, const Shape& shape, const Limits& limits,
                   const MakeMemory& make_memory, const Ask& ask) {
  check_poses(poses, shape);
  for_each_block(poses.size(), limits, make_memory,
                 [&](auto& memory, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     ask(memory, poses[i], i);
                   }
                 });
}

/// `cut` if a query of the batch was.
[[nodiscard]] inline Coverage coverage_of(std::span<const Coverage> coverages) {
  return std::find(coverages.begin(), coverages.end(), Coverage::cut) == coverages.end()
             ? Coverage::complete
             : Coverage::cut;
}

/// What the queries of a batch cost together.
[[nodiscard]] inline Cost sum_of(const std::vector<Cost>& costs) {
  Cost sum;
  for (const Cost& cost : costs) {
    sum += cost;
  }
  return sum;
}

/// Appends a block's part of a column.
template <class T>
void append(std::vector<T>& column, const std::vector<T>& part) {
  column.insert(column.end(), part.begin(), part.end());
}

/// The same for a column of rows of any length: row k is [offsets[k], offsets[k + 1]) of `values`.
template <class T>
void append_rows(std::vector<std::uint64_t>& offsets, std::vector<T>& values,
                 const std::vector<std::uint64_t>& part_offsets,
                 const std::vector<T>& part_values) {
  const std::uint64_t begin = values.size();
  append(values, part_values);
  for (std::size_t k = 1; k < part_offsets.size(); ++k) {
    offsets.push_back(begin + part_offsets[k]);
  }
}

/// Writes such a column by rows that come in any order, each once at most. Keeps its memory.
template <class T>
class RowWriter {
 public:
  /// Begins a column of `rows` rows, none of which has a value yet.
  void begin(std::size_t rows, std::vector<std::uint64_t>& offsets, std::vector<T>& values) {
    offsets_ = &offsets;
    values_ = &values;
    offsets.assign(rows + 1, 0);
    values.clear();
    order_.clear();
  }

  void add(std::size_t row, std::span<const T> values) {
    if (!values.empty()) {
      order_.push_back(row);
      (*offsets_)[row + 1] = values.size();
      values_->insert(values_->end(), values.begin(), values.end());
    }
  }

  /// Brings the rows into order.
  void finish() {
    std::vector<std::uint64_t>& offsets = *offsets_;
    for (std::size_t k = 1; k < offsets.size(); ++k) {
      offsets[k] += offsets[k - 1];
    }
    if (std::is_sorted(order_.begin(), order_.end())) {
      return;
    }
    std::vector<T> sorted(values_->size());
    auto from = values_->begin();
    for (const std::size_t row : order_) {
      const auto end = from + static_cast<std::ptrdiff_t>(offsets[row + 1] - offsets[row]);
      std::copy(from, end, sorted.begin() + static_cast<std::ptrdiff_t>(offsets[row]));
      from = end;
    }
    values_->swap(sorted);
  }

 private:
  std::vector<std::uint64_t>* offsets_ = nullptr;
  std::vector<T>* values_ = nullptr;
  std::vector<std::size_t> order_;  // rows that have values, as they came
};

}  // namespace soms::detail
