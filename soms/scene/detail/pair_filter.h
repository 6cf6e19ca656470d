/// \file
/// Pairs of boxes that nobody wants to know of.
#pragma once

#include "soms/scene/detail/pair_rows.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soms::detail {

/// Groups of boxes, whose members are not paired with each other, and single pairs.
class PairFilter {
 public:
  PairFilter() = default;

  /// Group 0 is none, and so is that of a box behind the end of `groups`. `ignored` in any order,
  /// each pair in either order, any number of times.
  PairFilter(std::vector<std::uint32_t> groups,
             std::span<const std::pair<std::uint32_t, std::uint32_t>> ignored);

  /// True if no pair is left out.
  [[nodiscard]] bool empty() const { return groups_.empty() && ignored_.size() == 0; }

  /// Empty where no box has a group.
  [[nodiscard]] std::span<const std::uint32_t> groups() const { return groups_; }

  [[nodiscard]] std::uint32_t group(std::uint32_t box) const {
    return box < groups_.size() ? groups_[box] : 0;
  }

  /// \pre `a` is less than `b`.
  [[nodiscard]] bool leaves_out(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t group_a = group(a);
    return (group_a != 0 && group_a == group(b)) || ignores(a, b);
  }

  /// False if there are no single pairs.
  [[nodiscard]] bool ignores_any() const { return ignored_.size() != 0; }

  /// True for one of the single pairs. \pre `a` is less than `b`.
  [[nodiscard]] bool ignores(std::uint32_t a, std::uint32_t b) const {
    return a < ignored_.rows() && !ignored_.row(a).empty() && holds(ignored_.row(a), b);
  }

  [[nodiscard]] std::size_t memory() const { return bytes(groups_) + ignored_.memory(); }

 private:
  [[nodiscard]] static bool holds(std::span<const std::uint32_t> sorted, std::uint32_t value);

  std::vector<std::uint32_t> groups_;
  PairRows ignored_;
};

}  // namespace soms::detail
