/// \file
/// Pairs of boxes in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Sorts pairs `a << 32 | b` of boxes into `sorted`, by `a` and then by `b`; bit 63 of a pair goes
/// along and does not count. `pairs` is scratch afterwards.
/// \pre   `a` and `b` less than `boxes`, at most 2^30 of them.
/// \cost  O(n), in passes without branches; memory is reused.
void sort_box_pairs(std::span<std::uint64_t> pairs, std::size_t boxes,
                    std::vector<std::uint64_t>& sorted);

}  // namespace soms::detail
