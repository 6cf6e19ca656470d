/// \file
/// Pairs of boxes in rows: one row a box, with its partners of higher number.
#pragma once

#include "soms/scene/detail/kept_memory.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Pairs sorted by counting.
class PairRows {
 public:
  /// Replaces the content by `pairs` (`a << 32 | b`, in any order, all of them different).
  /// \pre   `a < b < rows` in each.
  /// \cost  O(rows + pairs), and sorting within the rows.
  void assign(std::size_t rows, std::span<const std::uint64_t> pairs);

  /// Gives back memory that is far more than the content needs.
  void give_back() {
    detail::give_back(begins_);
    detail::give_back(partners_);
  }

  /// Partners of `a`, ascending.
  [[nodiscard]] std::span<const std::uint32_t> row(std::size_t a) const {
    return std::span(partners_).subspan(begins_[a], begins_[a + 1] - begins_[a]);
  }

  [[nodiscard]] std::size_t rows() const { return begins_.empty() ? 0 : begins_.size() - 1; }

  [[nodiscard]] std::size_t size() const { return partners_.size(); }

  [[nodiscard]] std::size_t memory() const { return bytes(begins_) + bytes(partners_); }

 private:
  std::vector<std::size_t> begins_;
  std::vector<std::uint32_t> partners_;
};

}  // namespace soms::detail
